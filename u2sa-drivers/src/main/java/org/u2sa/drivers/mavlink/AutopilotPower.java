package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.BatteryStatus;
import io.dronefleet.mavlink.common.SysStatus;
import java.util.Optional;
import org.u2sa.messages.BatteryState;

/**
 * The autopilot's batteries, from BATTERY_STATUS, or from SYS_STATUS until a BATTERY_STATUS
 * arrives.
 */
final class AutopilotPower {
  private static final double MILLI = 1.0e-3;
  private static final double CENTI = 1.0e-2;
  private static final int UNKNOWN_MV = 65_535;

  private final String sensorName;
  private boolean hasDetails;

  AutopilotPower(String sensorName) {
    this.sensorName = sensorName;
  }

  /** Empty once BATTERY_STATUS arrives, or if the voltage is unknown. */
  Optional<BatteryState> of(SysStatus message) {
    if (hasDetails || message.voltageBattery() == UNKNOWN_MV) {
      return Optional.empty();
    }
    BatteryState state =
        new BatteryState().sensorName(sensorName).voltage(message.voltageBattery() * MILLI);
    return Optional.of(withRest(state, message.currentBattery(), message.batteryRemaining()));
  }

  /** Empty if the voltage is unknown. */
  Optional<BatteryState> of(BatteryStatus message) {
    int sumMv = 0;
    boolean isKnown = false;
    for (int mv : message.voltages()) { // per cell, or the total in the first entry
      if (mv != UNKNOWN_MV) {
        sumMv += mv;
        isKnown = true;
      }
    }
    if (!isKnown) {
      return Optional.empty();
    }
    for (int mv : message.voltagesExt()) { // cells 11 to 14; 0 if absent
      sumMv += mv;
    }
    hasDetails = true;
    String name = message.id() == 0 ? sensorName : sensorName + " " + message.id();
    BatteryState state = new BatteryState().sensorName(name).voltage(sumMv * MILLI);
    return Optional.of(withRest(state, message.currentBattery(), message.batteryRemaining()));
  }

  /** Empty for negative values, which mean unknown. */
  private static BatteryState withRest(BatteryState state, int centiamps, int percent) {
    if (centiamps >= 0) {
      state.current(centiamps * CENTI);
    }
    if (percent >= 0 && percent <= 100) {
      state.remaining(percent);
    }
    return state;
  }
}
