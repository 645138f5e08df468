package org.u2sa.drivers.link;

import java.util.function.Consumer;
import org.u2sa.device.port.Device;
import org.u2sa.testkit.DeviceContract;

/** A driver over a line in memory, and what the device at its other end says. */
public class LinkedBench<R extends Device.Reading> extends DeviceContract.Bench<R> {
  private final MemoryLink link;
  private final Consumer<MemoryLink> says;
  private final long everyMicros;
  private final Device<R> device;

  /** With a device that says something each so often. */
  public LinkedBench(
      String name, MemoryLink link, Device<R> device, long everyMicros, Consumer<MemoryLink> says) {
    super(name);
    this.link = link;
    this.device = device;
    this.everyMicros = everyMicros;
    this.says = says;
  }

  @Override
  public Device<R> device() {
    return device;
  }

  @Override
  public void live(long nowMicros) {
    if (nowMicros % everyMicros == 0 && link.isConnected()) {
      says.accept(link);
    }
  }

  @Override
  public void plug(boolean in) {
    if (in) {
      link.plug();
    } else {
      link.unplug();
    }
  }
}
