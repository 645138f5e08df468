package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.recorder.foxglove.SceneFrame;

/** Scans, images, maps and paths as standard ROS messages. */
final class RosScenes {
  private static final int FLOAT32 = 7; // PointField.FLOAT32
  private static final int POINT_BYTES = 3 * Float.BYTES;
  private static final double PERCENT = 100.0;
  private static final int UNKNOWN_CELL = -1;

  private final RosFrames frames;

  RosScenes(RosFrames frames) {
    this.frames = frames;
  }

  /** {@code sensor_msgs/LaserScan} in the scanner's frame; empty if its steps are unequal. */
  static Optional<Object> scan(RangeScan scan) {
    List<RangeScan.Beam> beams = scan.beams();
    if (beams.isEmpty() || !scan.angles().isEmpty()) {
      return Optional.empty();
    }
    List<Object> ranges = new ArrayList<>(beams.size());
    beams.forEach(beam -> ranges.add(beam.range().orElse(Double.POSITIVE_INFINITY)));
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(RosStates.stamp(scan), RosStates.frameOf(scan.sensorName())),
            "angle_min",
            scan.startAngle(),
            "angle_max",
            beams.get(beams.size() - 1).angle(),
            "angle_increment",
            scan.angleIncrement(),
            "time_increment",
            scan.timeIncrement(),
            "scan_time",
            scan.timeIncrement() * beams.size(),
            "range_min",
            scan.minRange(),
            "range_max",
            scan.maxRange(),
            "ranges",
            ranges,
            "intensities",
            List.of()));
  }

  /** {@code tf2_msgs/TFMessage} of a scanner on the vehicle. */
  Optional<Object> scanner(RangeScan scan) {
    if (!scan.referenceFrame().equals(ReferenceFrame.BODY)) {
      return Optional.empty();
    }
    // The pose is in BODY, which is left-handed: y, roll and yaw have the opposite sign in FRD.
    Rotation frd = Rotation.nedFromFrd(-scan.phi(), scan.theta(), -scan.psi());
    Rotation turn = RosFrames.FLU_FROM_FRD.times(frd).times(RosFrames.FLU_FROM_FRD);
    Point at = Point.of(scan.x(), scan.y(), -scan.z());
    return Optional.of(
        fields(
            "transforms",
            List.of(
                new RosFrames.Pose(RosFrames.BASE, at, turn)
                    .transform(RosStates.stamp(scan), RosStates.frameOf(scan.sensorName())))));
  }

  /** {@code sensor_msgs/PointCloud2} of a scan's echoes or a cloud; empty without a position. */
  Optional<Object> points(U2SAData message) {
    if (message instanceof RangeScan scan) {
      return scan.referenceFrame().equals(ReferenceFrame.BODY)
          ? cloud(scan, ReferenceFrame.BODY, scan.points())
          : Optional.empty();
    }
    return message instanceof PointCloud cloud
        ? cloud(cloud, cloud.referenceFrame(), cloud.points())
        : Optional.empty();
  }

  private Optional<Object> cloud(U2SAData from, ReferenceFrame frame, List<Point> points) {
    ByteBuffer data =
        ByteBuffer.allocate(points.size() * POINT_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    String name = RosFrames.BASE;
    for (Point point : points) {
      Optional<SceneFrame.Placed> placed = frames.place(frame, point);
      if (placed.isEmpty()) {
        return Optional.empty();
      }
      name = placed.get().frame();
      Point at = placed.get().point();
      data.putFloat((float) at.x()).putFloat((float) at.y()).putFloat((float) at.z());
    }
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(RosStates.stamp(from), name),
            "height",
            1,
            "width",
            points.size(),
            "fields",
            List.of(axis("x", 0), axis("y", Float.BYTES), axis("z", 2 * Float.BYTES)),
            "is_bigendian",
            false,
            "point_step",
            POINT_BYTES,
            "row_step",
            points.size() * POINT_BYTES,
            "data",
            Base64.getEncoder().encodeToString(data.array()),
            "is_dense",
            true));
  }

  private static Map<String, Object> axis(String name, int offset) {
    return fields("name", name, "offset", offset, "datatype", FLOAT32, "count", 1);
  }

  /** {@code sensor_msgs/CompressedImage}. */
  static Optional<Object> image(CameraImage image) {
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(RosStates.stamp(image), RosStates.frameOf(image.sensorName())),
            "format",
            image.format(),
            "data",
            image.data().toBase64()));
  }

  /** {@code nav_msgs/OccupancyGrid}; empty before the map has an origin. */
  Optional<Object> grid(OccupancyGrid grid) {
    Optional<SceneFrame.Placed> anchor = frames.place(grid.referenceFrame(), grid.anchor());
    if (anchor.isEmpty() || grid.columns() == 0) {
      return Optional.empty();
    }
    byte[] cells = grid.cells();
    List<Object> data = new ArrayList<>(cells.length);
    for (byte cell : cells) {
      data.add(
          cell == OccupancyGrid.UNKNOWN
              ? UNKNOWN_CELL
              : (int) Math.round(PERCENT * OccupancyGrid.probability(cell)));
    }
    Point corner = anchor.get().point().plus(Point.of(grid.left(), grid.bottom(), 0.0));
    RosSpelling.Time stamp = RosStates.stamp(grid);
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(stamp, anchor.get().frame()),
            "info",
            fields(
                "map_load_time",
                stamp,
                "resolution",
                grid.resolution(),
                "width",
                grid.columns(),
                "height",
                grid.rows(),
                "origin",
                fields("position", RosFrames.xyz(corner), "orientation", RosFrames.upright())),
            "data",
            data));
  }

  /** {@code nav_msgs/Path}; empty before the map has an origin. */
  Optional<Object> path(PlannedPath path) {
    List<Object> poses = new ArrayList<>();
    String frame = RosFrames.MAP;
    for (Point point : path.points()) {
      Optional<SceneFrame.Placed> placed = frames.place(path.referenceFrame(), point);
      if (placed.isEmpty()) {
        return Optional.empty();
      }
      frame = placed.get().frame();
      poses.add(
          fields(
              "header",
              new RosSpelling.Header(RosStates.stamp(path), frame),
              "pose",
              fields(
                  "position",
                  RosFrames.xyz(placed.get().point()),
                  "orientation",
                  RosFrames.upright())));
    }
    return Optional.of(
        fields("header", new RosSpelling.Header(RosStates.stamp(path), frame), "poses", poses));
  }
}
