package org.u2sa.device.port;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A radar that tracks targets itself, such as a ship's ARPA. */
public interface TrackingRadar extends Device<TrackingRadar.Tracks> {
  /**
   * The tracked targets.
   *
   * @param measuredAtMicros time of the radar's last message
   * @param tracks one per id, sorted by id
   */
  record Tracks(long measuredAtMicros, List<Track> tracks) implements Reading {}

  /**
   * A target as measured from the radar.
   *
   * @param id track number
   * @param measuredAtMicros time of its last measurement [µs of the run's clock]
   * @param rangeM slant range [m]
   * @param elevationRad above the horizon [rad]; empty if the radar does not measure it
   * @param speedMps over ground [m/s]; empty if unknown
   * @param course over ground; empty if the speed is
   */
  record Track(
      String id,
      long measuredAtMicros,
      double rangeM,
      Direction bearing,
      OptionalDouble elevationRad,
      OptionalDouble speedMps,
      Optional<Direction> course) {}

  /**
   * A horizontal direction.
   *
   * @param rad clockwise [rad]
   * @param isTrue whether from true north, otherwise from the radar's zero
   */
  record Direction(double rad, boolean isTrue) {}
}
