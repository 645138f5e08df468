package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.U2SAService;

/** Reads a GNSS receiver for a service, and reports loss and recovery of the fix. */
public final class FixReader {
  private final U2SAService service;
  private final String sensorName;
  private final DeviceReader<GpsFix> reader;
  private final long delayMicros;
  private boolean hasFix = true; // so that a receiver without an initial fix is reported too

  /**
   * @param sensorName sensor name for messages
   * @param silentAfterS time without a reading after which the receiver counts as silent [s]
   * @param delayS latency from a fix's validity to its reading's timestamp [s]
   */
  public FixReader(
      U2SAService service,
      GpsReceiver receiver,
      String sensorName,
      double silentAfterS,
      double delayS) {
    this.service = service;
    this.sensorName = sensorName;
    reader = new DeviceReader<>(service, "the GPS receiver", receiver, silentAfterS);
    delayMicros = Clock.micros(delayS);
  }

  /**
   * Returns the state from a new valid fix, in GLOBAL, timestamped with its validity, for
   * publishing; call it at each step.
   */
  public Optional<StateInformation> next(long nowMicros) {
    Optional<GpsFix> fix = reader.next(nowMicros);
    fix.ifPresent(this::report);
    return fix.filter(GpsFix::valid).map(this::state);
  }

  private StateInformation state(GpsFix fix) {
    StateInformation state = fix.toState().sensorName(sensorName);
    state.timestamp(fix.measuredAtMicros() - delayMicros);
    return state;
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
