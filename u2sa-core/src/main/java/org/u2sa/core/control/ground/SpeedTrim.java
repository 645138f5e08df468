package org.u2sa.core.control.ground;

import java.util.OptionalDouble;
import org.u2sa.service.HandOver;

/**
 * Takes out what the vehicle is steadily slower or faster than it is to be: slopes, soft ground, a
 * battery that runs down. An integral of the speed's error, bounded; it is none while the vehicle
 * stands, so that what is to stand never creeps.
 */
final class SpeedTrim {
  private double trimMps;

  void handOver(HandOver state) {
    state.number("SPEED TRIM", trimMps);
  }

  void takeOver(HandOver state) {
    trimMps = state.number("SPEED TRIM").orElse(0.0);
  }

  /**
   * What to add to the speed that is commanded [m/s].
   *
   * @param gain for each second of the error [1/s]; 0: no feedback
   * @param mostMps of the answer, either way [m/s]
   */
  double step(Drive drive, OptionalDouble measuredMps, double gain, double mostMps, double stepS) {
    if (drive.speedMps() <= 0.0) {
      trimMps = 0.0;
    } else if (measuredMps.isPresent()) {
      double error = drive.speedMps() - measuredMps.getAsDouble();
      trimMps = Math.max(-mostMps, Math.min(mostMps, trimMps + gain * stepS * error));
    }
    return trimMps;
  }
}
