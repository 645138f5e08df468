package org.u2sa.gcs.mavlink.command;

import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import java.util.function.IntFunction;
import java.util.function.LongSupplier;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ManualDrive;

/**
 * Sticks of one station: MANUAL_CONTROL and RC_CHANNELS_OVERRIDE. They take effect only in the mode
 * Manual, and only on the connection that selected it.
 */
public final class StickInput {
  private static final double FULL = 1000.0;
  private static final int NO_AXIS = Short.MAX_VALUE; // INT16_MAX: not supported by the station
  private static final int CENTRE = 1500; // [µs]
  private static final int SPAN = 500;
  private static final int SHORTEST = 800;
  private static final int LONGEST = 2200;
  private static final double DEAD_BAND = 0.02;
  private static final long SHORTEST_INTERVAL_MICROS = 20_000;

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final IntFunction<String> drivers;
  private final int mavlinkId;
  private final LongSupplier micros;
  private final GroundStation station;
  private ThrottleStick throttle = new ThrottleStick();
  private long saidMicros;

  /**
   * @param drivers name of the person driving at a station, by MAVLink system ID
   * @param mavlinkId the vehicle's MAVLink system ID
   * @param micros real time [µs]
   */
  public StickInput(
      VehicleStatus vehicle,
      VehicleOrders orders,
      IntFunction<String> drivers,
      int mavlinkId,
      LongSupplier micros,
      GroundStation station) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.drivers = drivers;
    this.mavlinkId = mavlinkId;
    this.micros = micros;
    this.station = station;
  }

  /** Handles a message; false if it does not concern sticks. */
  public boolean handle(Object message, Sender from) {
    if (message instanceof ManualControl sticks) {
      if (sticks.target() == mavlinkId && isDriver(from)) {
        drive(sticks, from);
      }
    } else if (message instanceof RcChannelsOverride channels) {
      if (isDriver(from)) {
        drive(pulse(channels.chan3Raw()), pulse(channels.chan1Raw()), from);
      }
    } else {
      return false;
    }
    return true;
  }

  private boolean isDriver(Sender from) {
    boolean isDriver = vehicle.driver().filter(drivers.apply(from.system())::equals).isPresent();
    if (!isDriver) {
      throttle = new ThrottleStick();
    }
    return isDriver;
  }

  /** Either stick drives, because stations differ in which one they use. */
  private void drive(ManualControl sticks, Sender from) {
    if (sticks.z() != NO_AXIS && throttle.see(sticks.z())) {
      station.text(MavSeverity.MAV_SEVERITY_WARNING, ThrottleStick.NOT_AT_REST);
    }
    double forward = sticks.z() == NO_AXIS ? 0.0 : throttle.share(sticks.z());
    drive(axis(sticks.x()) + forward, axis(sticks.y()) + axis(sticks.r()), from);
  }

  private static double axis(int value) {
    return value == NO_AXIS ? 0.0 : value / FULL;
  }

  /** A channel that is released or ignored is centred. */
  private static double pulse(int lengthMicros) {
    return lengthMicros < SHORTEST || lengthMicros > LONGEST
        ? 0.0
        : (lengthMicros - CENTRE) / (double) SPAN;
  }

  private void drive(double forward, double right, Sender from) {
    long now = micros.getAsLong();
    if (now - saidMicros < SHORTEST_INTERVAL_MICROS) {
      return;
    }
    saidMicros = now;
    orders.tell(
        Channels.MANUAL_DRIVE,
        new ManualDrive()
            .operator(drivers.apply(from.system()))
            .speedShare(share(forward))
            .turnShare(share(-right)));
  }

  private static double share(double value) {
    return Math.abs(value) < DEAD_BAND ? 0.0 : Math.max(-1.0, Math.min(1.0, value));
  }
}
