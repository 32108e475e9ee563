/* lober_overlap_matrix for Octave and MATLAB: [areas, crossings] = lober_overlap_matrix_mex(points, begin), points 2 x
   n, one point a column, begin the number of points before each curve, and of all at the end: [0 1000 2000]. mkoctfile
   --mex lober_overlap_matrix_mex.c $(pkg-config --cflags --libs lober) */
#include <lober/lober.h>
#include <mex.h>
#include <stdlib.h>

static mxArray* matrix(const lober_result* result, const char* name) {
  lober_array array;
  if (lober_array_named(result, name, &array) != LOBER_OK) mexErrMsgTxt(lober_message());
  mxArray* made = mxCreateDoubleMatrix(array.rows, array.columns, mxREAL);
  for (size_t k = 0; k < array.rows * array.columns; ++k) { /* row by row here, column by column there */
    mxGetPr(made)[k % array.columns * array.rows + k / array.columns] = ((const double*)array.data)[k];
  }
  return made;
}

void mexFunction(int outputs, mxArray* output[], int inputs, const mxArray* input[]) {
  if (inputs != 2 || mxGetM(input[0]) != 2 || mxGetNumberOfElements(input[1]) < 1)
    mexErrMsgTxt("points, 2 x n, and where curves begin are needed");
  const size_t count = mxGetNumberOfElements(input[1]) - 1;
  size_t* begin = mxMalloc((count + 1) * sizeof(size_t)); /* which belongs to Octave: it is freed with the call */
  for (size_t k = 0; k <= count; ++k) {
    const double number = mxGetPr(input[1])[k];
    if (!(number >= 0 && number <= (double)mxGetN(input[0]))) mexErrMsgTxt("a curve begins beyond the points");
    begin[k] = (size_t)number;
  }
  lober_result* result = NULL;
  if (lober_overlap_matrix(mxGetPr(input[0]), begin, count, NULL, NULL, 0, "what=intersection,crossings dense=1",
                           &result) != LOBER_OK)
    mexErrMsgTxt(lober_message());
  output[0] = matrix(result, "intersection");
  if (outputs > 1) output[1] = matrix(result, "crossings");
  lober_result_free(result);
}
