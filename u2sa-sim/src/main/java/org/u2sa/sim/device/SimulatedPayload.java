package org.u2sa.sim.device;

import org.u2sa.device.port.Device;

/** Base of the simulated payloads and their sensors, which are in {@code org.u2sa.sim.payload}. */
public abstract class SimulatedPayload<R extends Device.Reading> extends SimulatedDevice<R> {
  /** See {@link SimulatedDevice}. */
  protected SimulatedPayload(double rateHz, double latencyS) {
    super(rateHz, latencyS);
  }

  /** Advances to a time; called at each read while the device is plugged in. */
  protected void advance(long nowMicros) {}

  /** The reading at the given time [µs, run's clock], which is also its timestamp. */
  protected abstract R sense(long stampMicros);

  @Override
  final void tell(long nowMicros) {
    advance(nowMicros);
  }

  @Override
  protected final R measure(double timeS, long measuredAtMicros) {
    return sense(measuredAtMicros);
  }
}
