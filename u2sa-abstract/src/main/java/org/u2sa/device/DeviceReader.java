package org.u2sa.device;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.device.port.Device;
import org.u2sa.service.U2SAService;

/**
 * Reads a device for the service that owns it, on its thread: returns each reading once, and
 * reports device faults in log and health.
 */
public final class DeviceReader<R extends Device.Reading> {
  private final U2SAService service;
  private final Device<R> device;
  private final DeviceWatch watch;
  private Optional<R> last = Optional.empty();
  private String said = "";
  private long refused; // readings rejected by a message
  private String refusal = "";

  /**
   * @param name name of the device in log and health
   * @param silentAfterS time without a reading after which a connected device counts as silent [s]
   */
  public DeviceReader(U2SAService service, String name, Device<R> device, double silentAfterS) {
    this.service = service;
    this.device = device;
    watch = new DeviceWatch(service, name, device, silentAfterS);
  }

  /**
   * The new reading since the last call, if any; call it at each step.
   *
   * @param nowMicros current time [µs of the run's clock]
   */
  public Optional<R> next(long nowMicros) {
    watch.look(nowMicros);
    Optional<R> newest = device.read(nowMicros);
    reportMalformed();
    reportTrouble();
    boolean isNew = newest.isPresent() && !newest.equals(last);
    last = newest;
    if (!isNew) {
      return Optional.empty();
    }
    watch.heard(nowMicros);
    return newest;
  }

  /**
   * Maps a reading to messages. A reading with values that a message rejects, such as a voltage
   * below zero, is dropped, counted and reported as malformed data (empty).
   *
   * @param mapping throws IllegalArgumentException for such values
   */
  public <T> Optional<T> mapped(Supplier<T> mapping) {
    try {
      return Optional.of(mapping.get());
    } catch (IllegalArgumentException e) {
      refused++;
      refusal = String.valueOf(e.getMessage());
      reportMalformed();
      return Optional.empty();
    }
  }

  private void reportMalformed() {
    String why = device.lastRefusal();
    watch.malformed(device.malformed() + refused, why.isEmpty() ? refusal : why);
  }

  /** The reading at the last call of {@link #next}, new or not. */
  public Optional<R> latest() {
    return last;
  }

  /**
   * Reports faults of a connected device, such as a refused setup; the watch reports a lost one.
   */
  private void reportTrouble() {
    String trouble = device.isConnected() ? device.trouble() : "";
    if (!trouble.equals(said)) {
      said = trouble;
      if (!trouble.isEmpty()) {
        service.trouble(trouble);
      }
    }
  }
}
