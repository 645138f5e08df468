package org.u2sa.gcs.ros;

import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.recorder.foxglove.SceneFrame;

/**
 * The frames of REP 105, east-north-up and forward-left-up: {@code map} at the first global
 * position received by any client, {@code odom} for local frames, {@code base_link} for the
 * vehicle. Shared by all clients, so that their maps agree. Thread-safe.
 */
final class RosFrames {
  static final String MAP = "map";
  static final String ODOM = "odom";
  static final String BASE = "base_link";

  /** Converts between forward-left-up and forward-right-down; its own inverse. */
  static final Rotation FLU_FROM_FRD = Rotation.nedFromFrd(Math.PI, 0.0, 0.0);

  private final SceneFrame scene = new SceneFrame(); // guarded by this
  private Pose inOdom; // newest; null until known; guarded by this

  /**
   * Pose of a frame in its parent.
   *
   * @param turn from the child's axes to the parent's
   */
  record Pose(String frame, Point position, Rotation turn) {
    /** This pose as fields of {@code geometry_msgs/Pose}. */
    Map<String, Object> fields() {
      return RosSpelling.fields("position", xyz(position), "orientation", quaternion(turn));
    }

    /** This pose as a {@code geometry_msgs/TransformStamped}. */
    Map<String, Object> transform(RosSpelling.Time stamp, String child) {
      return RosSpelling.fields(
          "header",
          new RosSpelling.Header(stamp, frame),
          "child_frame_id",
          child,
          "transform",
          RosSpelling.fields("translation", xyz(position), "rotation", quaternion(turn)));
    }
  }

  static Map<String, Object> xyz(Point point) {
    return RosSpelling.fields("x", point.x(), "y", point.y(), "z", point.z());
  }

  static Map<String, Object> quaternion(Rotation turn) {
    double[] q =
        SceneFrame.xyzw(
            turn.times(Point.of(1.0, 0.0, 0.0)),
            turn.times(Point.of(0.0, 1.0, 0.0)),
            turn.times(Point.of(0.0, 0.0, 1.0)));
    return RosSpelling.fields("x", q[0], "y", q[1], "z", q[2], "w", q[3]);
  }

  /** No rotation, as fields of {@code geometry_msgs/Quaternion}. */
  static Map<String, Object> upright() {
    return RosSpelling.fields("x", 0.0, "y", 0.0, "z", 0.0, "w", 1.0);
  }

  /** State in GLOBAL or LOCAL_NED; empty if it is in the vehicle's frame or has no position. */
  static Optional<StateInformation> placed(StateInformation state) {
    ReferenceFrame frame = state.referenceFrame();
    if (frame.isBody() || state.x().isEmpty() || state.y().isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        state.in(frame.isLocal() ? ReferenceFrame.LOCAL_NED : ReferenceFrame.GLOBAL));
  }

  /** Attitude of a state in GLOBAL or LOCAL_NED; absent angles count as 0. */
  static Attitude attitude(StateInformation state) {
    return new Attitude(
        state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElse(0.0));
  }

  /** Pose of the vehicle; empty if the state has no position outside the vehicle's own frame. */
  synchronized Optional<Pose> pose(StateInformation state) {
    Optional<Pose> pose = placed(state).map(this::ofPlaced);
    pose.filter(each -> each.frame().equals(ODOM)).ifPresent(each -> inOdom = each);
    return pose;
  }

  private Pose ofPlaced(StateInformation state) {
    Rotation turn = Rotation.NED_FROM_ENU.times(attitude(state).nedFromFrd()).times(FLU_FROM_FRD);
    Point at = Point.of(state.x().getAsDouble(), state.y().getAsDouble(), state.z().orElse(0.0));
    return state.referenceFrame().isLocal()
        ? new Pose(ODOM, Rotation.NED_FROM_ENU.times(at), turn)
        : new Pose(MAP, scene.onMap(Geodetic.of(at)), turn);
  }

  /**
   * Pose of the vehicle's parent in the map, given the vehicle's pose there: {@code odom} if the
   * vehicle has a local state. A ROS frame has only one parent.
   */
  synchronized Optional<Pose> odomInMap(Pose inMap) {
    if (inOdom == null) {
      return Optional.empty();
    }
    Rotation turn = inMap.turn().times(inOdom.turn().transposed());
    Point at = inMap.position().minus(turn.times(inOdom.position()));
    return Optional.of(new Pose(MAP, at, turn));
  }

  /** A point of a message; empty if it is global and the map has no origin yet. */
  synchronized Optional<SceneFrame.Placed> place(ReferenceFrame frame, Point point) {
    return scene
        .place(frame, point)
        .map(at -> new SceneFrame.Placed(named(at.frame()), at.point()));
  }

  private static String named(String frame) {
    return frame.equals(SceneFrame.BODY) ? BASE : frame.equals(SceneFrame.LOCAL) ? ODOM : MAP;
  }
}
