package org.u2sa.drivers.range;

import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;

/**
 * Distance by voltage through measured points, for sensors whose voltage falls with distance about
 * as its inverse does: between two points the inverse is interpolated. Immutable.
 */
public final class VoltageCurve implements AnalogRange {
  private static final double MARGIN = 0.1; // of a voltage, beyond the ends: sensors vary

  private final double[] metres;
  private final double[] volts;

  private VoltageCurve(double[] metres, double[] volts) {
    this.metres = metres;
    this.volts = volts;
  }

  /**
   * A curve through pairs of metres and volts, near to far.
   *
   * @throws BadInputException if there are fewer than two, or if distances do not grow and voltages
   *     do not fall
   */
  public static VoltageCurve of(double... metresAndVolts) {
    int points = metresAndVolts.length / 2;
    double[] metres = new double[points];
    double[] volts = new double[points];
    for (int i = 0; i < points; i++) {
      metres[i] = metresAndVolts[2 * i];
      volts[i] = metresAndVolts[2 * i + 1];
      boolean inOrder =
          i == 0 ? metres[0] > 0.0 : metres[i] > metres[i - 1] && volts[i] < volts[i - 1];
      if (!inOrder || !(volts[i] > 0.0)) {
        throw new BadInputException(
            "voltage curve: point " + metres[i] + " m, " + volts[i] + " V is not in order");
      }
    }
    if (points < 2 || metresAndVolts.length % 2 != 0) {
      throw new BadInputException(
          "voltage curve: " + metresAndVolts.length + " numbers are not two or more pairs");
    }
    return new VoltageCurve(metres, volts);
  }

  @Override
  public OptionalDouble rangeM(double measured) {
    int last = volts.length - 1;
    if (!(measured <= volts[0] * (1.0 + MARGIN)) || measured < volts[last]) {
      return OptionalDouble.empty(); // NaN, or nothing in reach
    }
    if (measured >= volts[0]) {
      return OptionalDouble.of(metres[0]);
    }
    int far = 1;
    while (measured < volts[far]) {
      far++;
    }
    double share = (measured - volts[far]) / (volts[far - 1] - volts[far]);
    double inverse = 1.0 / metres[far] + share * (1.0 / metres[far - 1] - 1.0 / metres[far]);
    return OptionalDouble.of(1.0 / inverse);
  }
}
