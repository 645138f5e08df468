package org.u2sa.world.object;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.world.grid.ScanEntry;
import org.u2sa.world.modeller.ScanPoses;

/** What moves among the echoes of all scanners. */
final class ScannedMovers {
  private static final int MAX_SCANNERS = 16; // a message may name any number

  private final Map<String, MovingEchoes> scanners = // by sensor, the one heard last at the end
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, MovingEchoes> eldest) {
          return size() > MAX_SCANNERS;
        }
      };

  /** What moves in a scan, in the map's frame; nothing while the vehicle's place is not known. */
  List<ObjectDescription> of(RangeScan scan, ScanPoses poses, ScanEntry.Band band) {
    return poses.first().frame().frame().isBody()
        ? List.of()
        : scanners
            .computeIfAbsent(scan.sensorName(), name -> new MovingEchoes())
            .of(scan, poses, band);
  }

  /** Begins anew, in another frame. */
  void clear() {
    scanners.clear();
  }
}
