package org.u2sa.drivers.sysfs;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * An output that Linux sets from a number in a file: {@code duty_cycle} of a PWM channel [ns]
 * (Documentation/ABI/testing/sysfs-class-pwm), {@code brightness} of an LED class device, as which
 * any pin may be configured (sysfs-class-led), or {@code value} of a pin.
 */
public final class SysfsOutput implements SwitchOutput {
  private static final double FULL_PERCENT = 100.0;

  private final Path file;
  private final Range range;
  private OptionalDouble wanted = OptionalDouble.empty();
  private long written = Long.MIN_VALUE;
  private Optional<Level> latest = Optional.empty();
  private String trouble = "not written yet";
  private int connections;

  /** Numbers in the file at both ends of the output. */
  public record Range(
      @Variable(min = -1e9, max = 1e9, ifAbsent = 1_000_000)
          @Description("SYSFS: number in the file at 0 %; a servo at a PWM channel: 1 ms in ns.")
          double valueAtZero,
      @Variable(min = -1e9, max = 1e9, ifAbsent = 2_000_000)
          @Description("SYSFS: number in the file at 100 %; a servo at a PWM channel: 2 ms in ns.")
          double valueAtFull) {}

  /** Uses a file that may be absent. */
  public SysfsOutput(Path file, Range range) {
    this.file = file;
    this.range = range;
  }

  @Override
  public Optional<Level> read(long nowMicros) {
    try {
      if (wanted.isPresent()) {
        write(wanted.getAsDouble());
      } else if (!Files.isWritable(file)) {
        throw new IOException(file + " cannot be written");
      }
      latest = Optional.of(new Level(nowMicros, wanted));
      connections += isConnected() ? 0 : 1;
      trouble = "";
    } catch (IOException e) { // a lost device is a state, not an exception
      trouble = e.toString();
      written = Long.MIN_VALUE;
    }
    return latest;
  }

  private void write(double percent) throws IOException {
    double share = percent / FULL_PERCENT;
    long number =
        Math.round(range.valueAtZero() + share * (range.valueAtFull() - range.valueAtZero()));
    if (number != written) {
      Files.write(file, Long.toString(number).getBytes(US_ASCII), StandardOpenOption.WRITE);
      written = number;
    } else if (!Files.isWritable(file)) {
      throw new IOException(file + " cannot be written");
    }
  }

  @Override
  public void set(double percent) {
    wanted = OptionalDouble.of(Math.max(0.0, Math.min(FULL_PERCENT, percent)));
  }

  @Override
  public boolean isConnected() {
    return trouble.isEmpty();
  }

  @Override
  public int connections() {
    return connections;
  }

  @Override
  public String trouble() {
    return trouble;
  }

  @Override
  public void leave() {
    // the number stays in the file
  }

  @Override
  public void close() {
    // the number stays in the file
  }

  /** Provider of OUTPUT = SYSFS. */
  public static final class Provider extends DeviceProvider<SwitchOutput> {
    public Provider() {
      super(SwitchOutput.class, "SYSFS");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Range.class);
    }

    @Override
    protected SwitchOutput open(String name, ServiceContext context) {
      return new SysfsOutput(
          IioPressure.file(context), context.configuration().settings(Range.class).get());
    }
  }
}
