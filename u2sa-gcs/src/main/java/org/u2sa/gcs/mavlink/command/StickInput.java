package org.u2sa.gcs.mavlink.command;

import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import java.util.function.LongSupplier;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ManualDrive;

/**
 * Sticks of one station: MANUAL_CONTROL and RC_CHANNELS_OVERRIDE. They count in the mode Manual
 * only, and of the station that chose it.
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
  private final int mavlinkId;
  private final LongSupplier micros;
  private long saidMicros;

  /**
   * @param mavlinkId the vehicle's MAVLink system ID
   * @param micros real time [µs]
   */
  public StickInput(
      VehicleStatus vehicle, VehicleOrders orders, int mavlinkId, LongSupplier micros) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.mavlinkId = mavlinkId;
    this.micros = micros;
  }

  /** Handles a message; false if it is not about sticks. */
  public boolean handle(Object message, Sender from) {
    if (message instanceof ManualControl sticks) {
      if (sticks.target() == mavlinkId) { // either stick drives, as stations differ in that
        drive(axis(sticks.x()) + axis(sticks.z()), axis(sticks.y()) + axis(sticks.r()), from);
      }
    } else if (message instanceof RcChannelsOverride channels) {
      drive(pulse(channels.chan3Raw()), pulse(channels.chan1Raw()), from);
    } else {
      return false;
    }
    return true;
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
    String driver = orders.driver(from.system());
    long now = micros.getAsLong();
    if (!vehicle.driver().filter(driver::equals).isPresent()
        || now - saidMicros < SHORTEST_INTERVAL_MICROS) {
      return;
    }
    saidMicros = now;
    orders.tell(
        Channels.MANUAL_DRIVE,
        new ManualDrive().operator(driver).speedShare(share(forward)).turnShare(share(-right)));
  }

  private static double share(double value) {
    return Math.abs(value) < DEAD_BAND ? 0.0 : Math.max(-1.0, Math.min(1.0, value));
  }
}
