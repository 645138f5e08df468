package org.u2sa.messages.frame;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/**
 * The Gauss coefficients of the World Magnetic Model, from NOAA's WMM.COF, and the resulting field.
 * Immutable.
 */
final class WmmCoefficients {
  private static final int DEGREE = 12;
  private static final int SIDE = DEGREE + 1;
  private static final double REFERENCE_KM = 6371.2;
  private static final String FILE = "WMM2025.COF";
  private static final int NUMBERS_A_LINE = 6;

  private final double[] g = new double[SIDE * SIDE]; // nT, at n * SIDE + m
  private final double[] h = new double[SIDE * SIDE];
  private final double[] gDot = new double[SIDE * SIDE]; // nT per year
  private final double[] hDot = new double[SIDE * SIDE];

  /** Loaded lazily, once. */
  private static final class Holder {
    static final WmmCoefficients WMM_2025 = new WmmCoefficients();
  }

  static WmmCoefficients held() {
    return Holder.WMM_2025;
  }

  private WmmCoefficients() {
    try (InputStream file = WmmCoefficients.class.getResourceAsStream(FILE);
        BufferedReader lines =
            new BufferedReader(new InputStreamReader(file, StandardCharsets.US_ASCII))) {
      lines.readLine(); // epoch, name and date of issue
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        String[] numbers = line.trim().split("\\s+");
        if (numbers.length == NUMBERS_A_LINE) { // excludes the trailing lines of nines
          take(numbers);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(FILE + " is not in the program", e);
    }
  }

  private void take(String[] numbers) {
    int n = Integer.parseInt(numbers[0]);
    int m = Integer.parseInt(numbers[1]);
    int at = n * SIDE + m;
    double schmidt = schmidt(n, m);
    g[at] = schmidt * Double.parseDouble(numbers[2]);
    h[at] = schmidt * Double.parseDouble(numbers[3]);
    gDot[at] = schmidt * Double.parseDouble(numbers[4]);
    hDot[at] = schmidt * Double.parseDouble(numbers[5]);
  }

  /** Factor from a Gauss-normalised to a Schmidt semi-normalised Legendre function. */
  private static double schmidt(int n, int m) {
    double factor = 1.0;
    for (int degree = 1; degree <= n; degree++) {
      factor *= (2.0 * degree - 1.0) / degree;
    }
    for (int order = 1; order <= m; order++) {
      factor *= Math.sqrt((n - order + 1.0) * (order == 1 ? 2.0 : 1.0) / (n + order));
    }
    return factor;
  }

  /**
   * The field [nT] towards geocentric north, east and down (WMM2025 report, eq. 10 to 16).
   *
   * @param years since the model's epoch
   * @param radiusKm distance from the earth's centre [km]
   * @param sine of the geocentric latitude
   * @param cosine of the geocentric latitude, positive
   * @param longitudeRad east positive
   */
  double[] field(double years, double radiusKm, double sine, double cosine, double longitudeRad) {
    double[] p = new double[SIDE * SIDE]; // Gauss-normalised Legendre functions of the sine
    double[] dp = new double[SIDE * SIDE]; // derivative by colatitude
    p[0] = 1.0;
    double north = 0.0;
    double east = 0.0;
    double down = 0.0;
    double ratio = REFERENCE_KM / radiusKm;
    double scale = ratio * ratio;
    for (int n = 1; n <= DEGREE; n++) {
      scale *= ratio;
      for (int m = 0; m <= n; m++) {
        int at = n * SIDE + m;
        legendre(p, dp, n, m, sine, cosine);
        double cos = Math.cos(m * longitudeRad);
        double sin = Math.sin(m * longitudeRad);
        double gNow = g[at] + years * gDot[at];
        double hNow = h[at] + years * hDot[at];
        double along = gNow * cos + hNow * sin;
        north += scale * along * dp[at];
        east += scale * m * (gNow * sin - hNow * cos) * p[at] / cosine;
        down -= scale * (n + 1.0) * along * p[at];
      }
    }
    return new double[] {north, east, down};
  }

  private static void legendre(double[] p, double[] dp, int n, int m, double sine, double cosine) {
    int at = n * SIDE + m;
    int before = at - SIDE;
    if (n == m) {
      p[at] = cosine * p[before - 1];
      dp[at] = cosine * dp[before - 1] + sine * p[before - 1];
      return;
    }
    p[at] = sine * p[before];
    dp[at] = sine * dp[before] - cosine * p[before];
    if (m <= n - 2) {
      double k = ((n - 1.0) * (n - 1.0) - m * m) / ((2.0 * n - 1.0) * (2.0 * n - 3.0));
      p[at] -= k * p[before - SIDE];
      dp[at] -= k * dp[before - SIDE];
    }
  }
}
