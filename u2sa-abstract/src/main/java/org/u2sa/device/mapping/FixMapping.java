package org.u2sa.device.mapping;

import java.util.Optional;
import org.u2sa.device.port.GpsFix;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.U2SAService;

/** Maps a GNSS receiver's fixes to states, and reports loss and recovery of the fix. */
public final class FixMapping {
  private final U2SAService service;
  private final String sensorName;
  private final long delayMicros;
  private boolean hasFix = true; // so that a receiver without an initial fix is reported too

  /**
   * @param delayS latency from a fix's validity to its reading's timestamp [s]
   */
  public FixMapping(U2SAService service, String sensorName, double delayS) {
    this.service = service;
    this.sensorName = sensorName;
    delayMicros = Clock.micros(delayS);
  }

  /** State in GLOBAL, timestamped with the validity of the fix; empty if it is invalid. */
  public Optional<StateInformation> state(GpsFix fix) {
    report(fix);
    if (!fix.valid()) {
      return Optional.empty();
    }
    StateInformation state = fix.toState().sensorName(sensorName);
    state.timestamp(fix.measuredAtMicros() - delayMicros);
    return Optional.of(state);
  }

  private void report(GpsFix fix) {
    if (fix.valid() == hasFix) {
      return;
    }
    hasFix = fix.valid();
    if (hasFix) {
      service.log("the GPS receiver has a fix");
    } else {
      service.trouble("the GPS receiver has no fix (" + fix.satellites() + " satellites)");
    }
  }
}
