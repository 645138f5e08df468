package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * Two quadrature decoders of the Linux counter subsystem, one per wheel: files {@code
 * /sys/bus/counter/devices/counterX/countY/count} (Documentation/ABI/testing/sysfs-bus-counter).
 * Narrow counters jump when they wrap; such jumps are rejected as impossible speeds.
 */
public final class LinuxCounter extends FileDevice<WheelEncoder.Ticks> implements WheelEncoder {
  /** Uses files that may be absent. */
  LinuxCounter(Path left, Path right) {
    super(List.of(left, right));
  }

  @Override
  protected Ticks reading(long nowMicros, double[] numbers) {
    return new Ticks(nowMicros, (int) (long) numbers[0], (int) (long) numbers[1]);
  }

  /** Provider of ENCODERS = LINUX COUNTER. */
  public static final class Provider extends DeviceProvider<WheelEncoder> {
    private record Files(
        @Variable(ifAbsentText = "/sys/bus/counter/devices/counter1/count0/count")
            @Description(
                "LINUX COUNTER: file of the right wheel's count; CONNECTION is the left wheel's.")
            String rightCounter) {}

    public Provider() {
      super(WheelEncoder.class, "LINUX COUNTER");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Files.class);
    }

    @Override
    protected WheelEncoder open(String name, ServiceContext context) {
      String right = context.configuration().settings(Files.class).get().rightCounter();
      return new LinuxCounter(IioPressure.file(context), context.configuration().resolve(right));
    }
  }
}
