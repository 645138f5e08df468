package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;

/**
 * Vehicle poses during one scan: states at the times of the first and last beam, interpolated in
 * between.
 *
 * @param first sighting at the time of the first beam
 * @param last state at the time of the last beam; empty: same as at the first
 */
public record ScanPoses(Sighting first, Optional<StateInformation> last) {
  /** Poses of a scan by a stationary vehicle, or with simultaneous beams. */
  public static ScanPoses still(Sighting sighting) {
    return new ScanPoses(sighting, Optional.empty());
  }

  /** Sensor pose at a fraction [0…1] of the scan. */
  public SensorPose at(RangeScan scan, double share) {
    Optional<StateInformation> vehicle =
        last.isPresent()
            ? Optional.of(PoseHistory.between(first.vehicle().orElseThrow(), last.get(), share))
            : first.vehicle();
    return SensorPose.of(scan, first.frame(), vehicle);
  }

  public boolean moved() {
    return last.isPresent();
  }
}
