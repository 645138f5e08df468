package org.u2sa.world.object;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.RangeScan;
import org.u2sa.world.grid.ScanEntry;
import org.u2sa.world.modeller.ScanPoses;

/** Detects moving objects in the echoes of all scanners. */
final class ScannedMovers {
  private static final int MAX_SCANNERS = 16; // messages may name any number of them

  private final Map<String, MovingEchoes> scanners = // by sensor, in order of last use
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, MovingEchoes> eldest) {
          return size() > MAX_SCANNERS;
        }
      };

  /** Moving objects in a scan, in the map's frame; none while the vehicle's pose is unknown. */
  List<ObjectDescription> of(RangeScan scan, ScanPoses poses, ScanEntry.Band band) {
    return poses.first().frame().frame().isBody()
        ? List.of()
        : scanners
            .computeIfAbsent(scan.sensorName(), name -> new MovingEchoes())
            .of(scan, poses, band);
  }

  /** Discards everything, because the frame changes. */
  void clear() {
    scanners.clear();
  }
}
