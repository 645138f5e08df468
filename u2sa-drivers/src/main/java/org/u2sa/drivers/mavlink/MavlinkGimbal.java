package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.GimbalDeviceAttitudeStatus;
import io.dronefleet.mavlink.common.GimbalDeviceFlags;
import io.dronefleet.mavlink.common.GimbalDeviceSetAttitude;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.payload.Gimbal;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.mavlink.MavlinkStream;

/**
 * A gimbal device of MAVLink's Gimbal Protocol v2 on its own line
 * (mavlink.io/en/services/gimbal_v2.html): GIMBAL_DEVICE_SET_ATTITUDE (284) out, and
 * GIMBAL_DEVICE_ATTITUDE_STATUS (285) in. Angles are relative to the vehicle.
 */
@SuppressWarnings("deprecation") // messages unfinished at the library's release
public final class MavlinkGimbal extends LinkedDevice<Gimbal.Pointing> implements Gimbal {
  private static final long SEND_MICROS = Clock.micros(0.05);
  private static final long HEARTBEAT_MICROS = Clock.micros(1.0);
  private static final int ONBOARD_COMPUTER = 191; // MAV_COMP_ID_ONBOARD_COMPUTER
  private static final int ROLL_AND_PITCH_LOCK = 4 | 8;
  private static final int YAW_LOCK = 16;
  private static final int YAW_IN_VEHICLE_FRAME = 32;
  private static final int YAW_IN_EARTH_FRAME = 64;
  private static final double UNIT_TOLERANCE = 0.1;

  private final Variables wiring;
  private final MavlinkStream stream;
  private double panRad;
  private double tiltRad;
  private boolean isPointed;
  private long sendDueMicros = Long.MIN_VALUE;
  private long heartbeatDueMicros = Long.MIN_VALUE;
  private int failures;

  /** Identification of the gimbal, and its stabilisation. */
  public record Variables(
      @Variable(min = 1, max = 255, ifAbsent = 1)
          @Description("MAVLINK: system ID of the gimbal, and of this service.")
          int gimbalSystem,
      @Variable(min = 1, max = 255, ifAbsent = 154)
          @Description("MAVLINK: component ID of the gimbal; 154: the first one.")
          int gimbalComponent,
      @Variable(ifAbsentText = "false")
          @Description("MAVLINK: whether the gimbal keeps roll and tilt relative to the horizon.")
          boolean horizonLock) {}

  /** Uses the link; closing the device closes it. */
  public MavlinkGimbal(ByteLink link, Variables wiring) {
    super(link);
    this.wiring = wiring;
    stream = new MavlinkStream(wiring.gimbalSystem(), ONBOARD_COMPUTER);
  }

  @Override
  protected void found(long nowMicros) {
    stream.reset();
    heartbeatDueMicros = Long.MIN_VALUE;
    sendDueMicros = Long.MIN_VALUE;
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    stream.accept(
        bytes,
        length,
        message -> {
          if (message.payload() instanceof GimbalDeviceAttitudeStatus status
              && message.systemId() == wiring.gimbalSystem()
              && message.componentId() == wiring.gimbalComponent()) {
            take(status, nowMicros);
          }
        });
  }

  private void take(GimbalDeviceAttitudeStatus status, long nowMicros) {
    failures = status.failureFlags().value();
    int flags = status.flags().value();
    boolean isOfTheEarth =
        (flags & YAW_IN_EARTH_FRAME) != 0
            || (flags & YAW_IN_VEHICLE_FRAME) == 0 && (flags & YAW_LOCK) != 0;
    if (isOfTheEarth) {
      return; // its pan relative to the vehicle is unknown
    }
    List<Float> q = status.q();
    double w = q.get(0);
    double x = q.get(1);
    double y = q.get(2);
    double z = q.get(3);
    double length = Math.sqrt(w * w + x * x + y * y + z * z);
    if (!(Math.abs(length - 1.0) < UNIT_TOLERANCE)) {
      refuse("GIMBAL_DEVICE_ATTITUDE_STATUS: quaternion of length " + length);
      return;
    }
    double yaw = Math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
    double pitch = Math.asin(Math.max(-1.0, Math.min(1.0, 2.0 * (w * y - z * x))));
    latest = Optional.of(new Pointing(nowMicros, -yaw, pitch)); // MAVLink's yaw is to the right
  }

  @Override
  protected void act(long nowMicros) {
    if (nowMicros >= heartbeatDueMicros) {
      heartbeatDueMicros = nowMicros + HEARTBEAT_MICROS;
      link.write(stream.encode(AutopilotPeer.heartbeat()));
    }
    if (isPointed && nowMicros >= sendDueMicros) {
      sendDueMicros = nowMicros + SEND_MICROS;
      link.write(stream.encode(attitude()));
    }
  }

  private GimbalDeviceSetAttitude attitude() {
    double halfYaw = -panRad / 2.0;
    double halfPitch = tiltRad / 2.0;
    int flags = YAW_IN_VEHICLE_FRAME | (wiring.horizonLock() ? ROLL_AND_PITCH_LOCK : 0);
    return GimbalDeviceSetAttitude.builder()
        .flags(EnumValue.<GimbalDeviceFlags>create(flags))
        .targetSystem(wiring.gimbalSystem())
        .targetComponent(wiring.gimbalComponent())
        .q( // yaw, then pitch
            List.of(
                (float) (Math.cos(halfYaw) * Math.cos(halfPitch)),
                (float) (-Math.sin(halfYaw) * Math.sin(halfPitch)),
                (float) (Math.cos(halfYaw) * Math.sin(halfPitch)),
                (float) (Math.sin(halfYaw) * Math.cos(halfPitch))))
        .angularVelocityX(Float.NaN) // the gimbal chooses its rates
        .angularVelocityY(Float.NaN)
        .angularVelocityZ(Float.NaN)
        .build();
  }

  @Override
  public void point(double newPanRad, double newTiltRad) {
    panRad = newPanRad;
    tiltRad = newTiltRad;
    isPointed = true;
  }

  @Override
  protected String ownTrouble() {
    return failures == 0 ? "" : "the gimbal reports failures " + failures;
  }

  @Override
  public long malformed() {
    return stream.malformed() + super.malformed();
  }

  @Override
  public String lastRefusal() {
    String own = super.lastRefusal();
    return own.isEmpty() ? stream.lastRefusal() : own;
  }

  @Override
  public void leave() {
    link.close();
  }

  /** Provider of GIMBAL = MAVLINK. */
  public static final class Provider extends LinkProvider<Gimbal> {
    public Provider() {
      super(
          Gimbal.class,
          Variables.class,
          (name, link, own) -> new MavlinkGimbal(link, own),
          "MAVLINK");
    }
  }
}
