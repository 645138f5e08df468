package org.u2sa.drivers.link;

import org.u2sa.device.port.Device;
import org.u2sa.sim.device.SimulatedDevice;
import org.u2sa.testkit.DeviceContract;

/** A simulated device without bytes. */
public final class SimulatedBench<R extends Device.Reading> extends DeviceContract.Bench<R> {
  private final SimulatedDevice<R> device;

  /** Over that device. */
  public SimulatedBench(String name, SimulatedDevice<R> device) {
    super(name);
    this.device = device;
  }

  @Override
  public Device<R> device() {
    return device;
  }

  @Override
  public void live(long nowMicros) {
    // measures by itself
  }

  @Override
  public void plug(boolean in) {
    device.plug(in);
  }
}
