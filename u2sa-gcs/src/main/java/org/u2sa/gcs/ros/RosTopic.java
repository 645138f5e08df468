package org.u2sa.gcs.ros;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.message.MessageJson;

/**
 * A topic that clients may subscribe to.
 *
 * @param name name with its slash
 * @param type type in the spelling of ROS 2
 * @param sources channels from which it is derived
 * @param maker converts a message to fields for {@link RosSpelling#json}; empty if the vehicle's
 *     message yields none
 */
record RosTopic(
    String name,
    String type,
    List<Channel<?>> sources,
    BiFunction<Channel<?>, U2SAData, Optional<Object>> maker) {
  /** Namespace of the native topics. */
  static final String NATIVE = "/u2sa/";

  private static final String NATIVE_TYPES = "u2sa_msgs/msg/";

  /** All topics, with positions in these frames. */
  static List<RosTopic> all(RosFrames frames) {
    RosStates states = new RosStates(frames);
    RosScenes scenes = new RosScenes(frames);
    RosMarkers markers = new RosMarkers(frames);
    List<RosTopic> all = new ArrayList<>();
    all.add(
        made(
            "/odom",
            "nav_msgs",
            "Odometry",
            StateInformation.class,
            states::odometry,
            Channels.STATE));
    all.add(
        made(
            "/odometry/local",
            "nav_msgs",
            "Odometry",
            StateInformation.class,
            states::odometry,
            Channels.LOCAL_STATE));
    all.add(
        made(
            "/fix",
            "sensor_msgs",
            "NavSatFix",
            StateInformation.class,
            RosStates::fix,
            Channels.SENSED_STATE));
    all.add(
        made(
            "/imu",
            "sensor_msgs",
            "Imu",
            InertialMeasurement.class,
            RosStates::imu,
            Channels.SENSED_STATE));
    all.add(
        made(
            "/scan", "sensor_msgs", "LaserScan", RangeScan.class, RosScenes::scan, Channels.SCANS));
    all.add(
        made(
            "/points",
            "sensor_msgs",
            "PointCloud2",
            U2SAData.class,
            scenes::points,
            Channels.SCANS,
            Channels.SENSED_OBJECTS,
            Channels.STATE));
    all.add(
        made(
            "/image/compressed",
            "sensor_msgs",
            "CompressedImage",
            CameraImage.class,
            RosScenes::image,
            Channels.IMAGES));
    all.add(
        made(
            "/map",
            "nav_msgs",
            "OccupancyGrid",
            OccupancyGrid.class,
            scenes::grid,
            Channels.GRID,
            Channels.STATE));
    all.add(
        made(
            "/plan",
            "nav_msgs",
            "Path",
            PlannedPath.class,
            scenes::path,
            Channels.PLANS,
            Channels.STATE));
    all.add(
        made(
            "/markers",
            "visualization_msgs",
            "MarkerArray",
            ObjectList.class,
            markers::of,
            Channels.OBJECTS,
            Channels.STATE));
    all.add(
        made(
            "/battery",
            "sensor_msgs",
            "BatteryState",
            BatteryState.class,
            RosStates::battery,
            Channels.POWER));
    all.add(
        made(
            RosTwist.TOPIC,
            "geometry_msgs",
            "Twist",
            ManualDrive.class,
            RosTwist::of,
            Channels.MANUAL_DRIVE));
    all.add(
        made("/clock", "rosgraph_msgs", "Clock", U2SAData.class, RosStates::clock, Channels.STATE));
    all.add(
        made(
            "/tf",
            "tf2_msgs",
            "TFMessage",
            U2SAData.class,
            message ->
                message instanceof RangeScan scan
                    ? scenes.scanner(scan)
                    : states.transforms((StateInformation) message),
            Channels.STATE,
            Channels.LOCAL_STATE,
            Channels.SCANS));
    Channels.all().forEach(channel -> all.add(ofChannel(channel)));
    return List.copyOf(all);
  }

  private interface Maker<T> {
    Optional<Object> make(T message);
  }

  private static <T extends U2SAData> RosTopic made(
      String name, String folder, String type, Class<T> from, Maker<T> maker, Channel<?>... of) {
    return new RosTopic(
        name,
        folder + "/msg/" + type,
        List.of(of),
        (channel, message) ->
            from.isInstance(message) ? maker.make(from.cast(message)) : Optional.empty());
  }

  private static RosTopic ofChannel(Channel<?> channel) {
    List<MessageType<?>> carried = channel.carriedTypes();
    String type = carried.size() == 1 ? carried.get(0).name() : U2SAData.TYPE.name();
    return new RosTopic(
        NATIVE + channel.name().replace('-', '_'),
        NATIVE_TYPES + type,
        List.of(channel),
        (any, message) -> Optional.of(MessageJson.plain(message)));
  }

  /** The channel of a native topic; empty for derived topics. */
  Optional<Channel<?>> nativeChannel() {
    return name.startsWith(NATIVE) ? Optional.of(sources.get(0)) : Optional.empty();
  }
}
