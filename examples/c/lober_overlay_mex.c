/* lober_overlay for Octave and MATLAB: [areas, lobes] = lober_overlay_mex(curve1, curve2), curves 2 x n, one point a column.
       mkoctfile --mex lober_overlay_mex.c $(pkg-config --cflags --libs lober) */
#include <lober/lober.h>
#include <mex.h>
#include <string.h>

void mexFunction(int outputs, mxArray* output[], int inputs, const mxArray* input[]) {
  if (inputs != 2 || mxGetM(input[0]) != 2 || mxGetM(input[1]) != 2) mexErrMsgTxt("two curves, 2 x n each, are needed");
  lober_result* result = NULL;
  if (lober_overlay(mxGetPr(input[0]), mxGetN(input[0]), mxGetPr(input[1]), mxGetN(input[1]), NULL, &result) != LOBER_OK)
    mexErrMsgTxt(lober_message());
  output[0] = mxCreateDoubleScalar(lober_number(result, "areas.c1_minus_c2"));
  if (outputs > 1) {
    lober_array lobes;
    lober_array_named(result, "pieces.c1_minus_c2.area", &lobes);
    output[1] = mxCreateDoubleMatrix(lobes.rows, 1, mxREAL);
    memcpy(mxGetPr(output[1]), lobes.data, lobes.rows * sizeof(double));
  }
  lober_result_free(result);
}
