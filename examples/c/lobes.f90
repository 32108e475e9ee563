! The same from Fortran 2003: gfortran lobes.f90 -llober -o lobes
program lobes
  use, intrinsic :: iso_c_binding
  implicit none

  type, bind(c) :: lober_array
    type(c_ptr) :: name
    integer(c_int) :: kind
    type(c_ptr) :: data
    integer(c_size_t) :: rows, columns
  end type

  interface
    integer(c_int) function lober_overlay(curve1, n1, curve2, n2, options, result) bind(c)
      import
      real(c_double), intent(in) :: curve1(2, *), curve2(2, *)
      integer(c_size_t), value :: n1, n2
      character(kind=c_char), intent(in) :: options(*)
      type(c_ptr) :: result
    end function
    integer(c_int) function lober_overlap_matrix(points1, begin1, count1, points2, begin2, count2, options, result) bind(c)
      import
      real(c_double), intent(in) :: points1(2, *)
      integer(c_size_t), intent(in) :: begin1(*)
      integer(c_size_t), value :: count1, count2
      type(c_ptr), value :: points2, begin2
      character(kind=c_char), intent(in) :: options(*)
      type(c_ptr) :: result
    end function
    integer(c_int) function lober_model_open(name, parameters, options, model) bind(c)
      import
      character(kind=c_char), intent(in) :: name(*), parameters(*), options(*)
      type(c_ptr) :: model
    end function
    integer(c_int) function lober_transport(model, options, result) bind(c)
      import
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: options(*)
      type(c_ptr) :: result
    end function
    integer(c_int) function lober_array_named(result, name, array) bind(c)
      import
      type(c_ptr), value :: result
      character(kind=c_char), intent(in) :: name(*)
      type(lober_array) :: array
    end function
    real(c_double) function lober_number(result, name) bind(c)
      import
      type(c_ptr), value :: result
      character(kind=c_char), intent(in) :: name(*)
    end function
    subroutine lober_result_free(result) bind(c)
      import
      type(c_ptr), value :: result
    end subroutine
    subroutine lober_model_free(model) bind(c)
      import
      type(c_ptr), value :: model
    end subroutine
  end interface

  integer, parameter :: n = 1000, circles = 5
  real(c_double), parameter :: pi = 3.14159265358979323846_c_double
  real(c_double) :: circle(2, n), wave(2, n), angle, radius
  real(c_double) :: row(2, n, circles)
  real(c_double), pointer :: flux(:), areas(:, :), counts(:, :)
  integer(c_size_t) :: begin(circles + 1)
  type(c_ptr) :: result, map
  type(lober_array) :: array
  integer :: k

  do k = 1, n
    angle = 2 * pi * (k - 1) / n
    radius = 1 + 0.2_c_double * sin(5 * angle)
    circle(:, k) = [cos(angle), sin(angle)]
    wave(:, k) = radius * circle(:, k)
  end do
  if (lober_overlay(circle, int(n, c_size_t), wave, int(n, c_size_t), c_null_char, result) /= 0) stop 1
  if (lober_array_named(result, 'pieces.c1_minus_c2.area' // c_null_char, array) /= 0) stop 1
  write (*, '(i0, a, f0.12, a)') array%rows, ' lobes of area ', &
    lober_number(result, 'areas.c1_minus_c2' // c_null_char), ' in all'
  call lober_result_free(result)

  if (lober_model_open('standard' // c_null_char, 'K=1.2' // c_null_char, c_null_char, map) /= 0) stop 1
  if (lober_transport(map, 'iterates=3' // c_null_char, result) /= 0) stop 1
  if (lober_array_named(result, 'turnstile.flux12' // c_null_char, array) /= 0) stop 1
  call c_f_pointer(array%data, flux, [2])
  write (*, '(a, f0.9)') 'flux ', flux(1)
  call lober_result_free(result)
  call lober_model_free(map)

  do k = 1, circles
    row(1, :, k) = circle(1, :) + 0.6_c_double * (k - 1)
    row(2, :, k) = circle(2, :)
  end do
  begin = [(int(n, c_size_t) * k, k = 0, circles)]
  if (lober_overlap_matrix(row, begin, int(circles, c_size_t), c_null_ptr, c_null_ptr, 0_c_size_t, &
    'what=intersection,crossings dense=1' // c_null_char, result) /= 0) stop 1
  ! Matrices come row by row, so that the first index here is the column.
  if (lober_array_named(result, 'intersection' // c_null_char, array) /= 0) stop 1
  call c_f_pointer(array%data, areas, [circles, circles])
  if (lober_array_named(result, 'crossings' // c_null_char, array) /= 0) stop 1
  call c_f_pointer(array%data, counts, [circles, circles])
  do k = 2, circles
    write (*, '(f0.9, a, i0)') areas(k, 1), ' ', nint(counts(k, 1))
  end do
  call lober_result_free(result)
end program
