package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.WheelEncoder;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * Two quadrature decoders of Linux's counter subsystem, one at each wheel: the files {@code
 * /sys/bus/counter/devices/counterX/countY/count} (Documentation/ABI/testing/sysfs-bus-counter).
 * Counters of fewer bits jump where they wrap; such a jump is dropped as a speed that no wheel has.
 */
public final class LinuxCounter extends FileDevice<WheelEncoder.Ticks> implements WheelEncoder {
  /** Of files that need not be there yet. */
  LinuxCounter(Path left, Path right) {
    super(List.of(left, right));
  }

  @Override
  Ticks reading(long nowMicros, double[] numbers) {
    return new Ticks(nowMicros, (int) (long) numbers[0], (int) (long) numbers[1]);
  }

  /** ENCODERS LINUX COUNTER in a configuration. */
  public static final class Provider extends DeviceProvider<WheelEncoder> {
    private record Files(
        @Variable(
                ifAbsentText = "/sys/bus/counter/devices/counter1/count0/count",
                text =
                    "LINUX COUNTER: file of the right wheel's count; CONNECTION is the left one's.")
            String rightCounter) {}

    /** For {@link java.util.ServiceLoader}. */
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
