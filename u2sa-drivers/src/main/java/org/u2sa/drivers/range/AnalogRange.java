package org.u2sa.drivers.range;

import java.util.OptionalDouble;

/** What a range finder's voltage means; for boards that measure voltages. */
@FunctionalInterface
public interface AnalogRange {
  /**
   * The distance at a voltage.
   *
   * @param volts at the sensor's output [V]
   * @return [m]; empty if nothing is in reach, or no such sensor gives this voltage
   */
  OptionalDouble rangeM(double volts);

  /**
   * MaxBotix LV-MaxSonar-EZ: supply / 512 volts an inch, 6…254 inches (data sheet PD11832). Nearer
   * objects read as 6 inches.
   *
   * @param supplyV its supply [V], 2.5…5.5
   */
  static AnalogRange maxBotixLv(double supplyV) {
    return volts -> SonarModel.LV.rangeM(volts / (supplyV / 512.0));
  }

  /**
   * Sharp GP2Y0A21YK0F, 0.10…0.80 m (data sheet OP13008EN): 0.4 V at 0.8 m, 1.9 V more at 0.1 m,
   * and between them the typical curve of its figure 2. Nearer than 0.1 m the voltage falls again,
   * so that such an object looks far: mount it 0.1 m back.
   */
  static AnalogRange sharpGp2y0a21() {
    return VoltageCurve.of(
        0.10, 2.30, 0.15, 1.65, 0.20, 1.30, 0.30, 0.92, 0.40, 0.74, 0.50, 0.61, 0.60, 0.52, 0.70,
        0.45, 0.80, 0.40);
  }
}
