package org.u2sa.device.port;

import java.util.List;
import org.u2sa.messages.frame.Point;

/** A 3-D lidar, or a stereo or depth camera that measures points. */
public interface PointScanner extends Device<PointScanner.Cloud> {
  /**
   * The points of one scan, such as a revolution of the lidar.
   *
   * @param measuredAtMicros time at which the scan ended
   * @param points along the scanner's own axes: x ahead, y left, z down [m]; directions without an
   *     echo are left out
   */
  record Cloud(long measuredAtMicros, List<Point> points) implements Reading {}
}
