package org.u2sa.core.control.ground;

import java.util.OptionalDouble;
import org.u2sa.service.HandOver;

/**
 * Takes out by how much a vehicle is steadily slower, or turns less, than it is told to: slopes,
 * soft ground, a battery that runs down, motors that are not alike. An integral of the error,
 * bounded; it is none while the vehicle stands, so that what is to stand never creeps.
 */
final class Trim {
  private final String name;
  private double trim;

  /**
   * @param name under which it is handed over
   */
  Trim(String name) {
    this.name = name;
  }

  void handOver(HandOver state) {
    state.number(name, trim);
  }

  void takeOver(HandOver state) {
    trim = state.number(name).orElse(0.0);
  }

  /**
   * What to add to what is demanded.
   *
   * @param moves whether the vehicle is to move ahead
   * @param measured the same quantity; empty if unknown
   * @param gain for each second of the error [1/s]; 0: no feedback
   * @param most of the answer, either way
   */
  double step(
      boolean moves,
      double demanded,
      OptionalDouble measured,
      double gain,
      double most,
      double stepS) {
    if (!moves) {
      trim = 0.0;
    } else if (measured.isPresent()) {
      double error = demanded - measured.getAsDouble();
      trim = Math.max(-most, Math.min(most, trim + gain * stepS * error));
    }
    return trim;
  }
}
