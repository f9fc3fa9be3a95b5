// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// x^y for x in [0,1], y > 0: whole powers by multiplication, since pow() of some drivers keeps 5 digits
float pellucidPower(float x, float y)
{
  float result = y == floor(y) || x == 0.0 ? 1.0 : pow(x, fract(y));
  float factor = x;
  for (uint n = uint(y); n != 0u; n >>= 1)
  {
    result *= (n & 1u) != 0u ? factor : 1.0;
    factor *= factor;
  }
  return x == 0.0 ? 0.0 : result;
}
