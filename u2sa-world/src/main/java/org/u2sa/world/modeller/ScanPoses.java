package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;

/**
 * Where the vehicle was during one scan: its state at the times of the first and of the last beam,
 * and in between by interpolation.
 */
public final class ScanPoses {
  private final Sighting first;
  private final Optional<StateInformation> last;

  /**
   * @param first at the time of the first beam
   * @param last state at the time of the last one; empty: as at the first
   */
  public ScanPoses(Sighting first, Optional<StateInformation> last) {
    this.first = first;
    this.last = last;
  }

  /** A scan from a vehicle that stands, or whose beams all went out at one moment. */
  public static ScanPoses still(Sighting sighting) {
    return new ScanPoses(sighting, Optional.empty());
  }

  /** The moment of the first beam. */
  public Sighting first() {
    return first;
  }

  /** Where the sensor was and how it was turned when a share [0…1] of the scan was done. */
  public SensorPose at(RangeScan scan, double share) {
    Optional<StateInformation> vehicle =
        last.isPresent()
            ? Optional.of(PoseHistory.between(first.vehicle().orElseThrow(), last.get(), share))
            : first.vehicle();
    return SensorPose.of(scan, first.frame(), vehicle);
  }

  /** Whether the vehicle moved during the scan. */
  public boolean moved() {
    return last.isPresent();
  }
}
