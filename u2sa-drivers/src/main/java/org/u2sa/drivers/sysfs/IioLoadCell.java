package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * A load cell at an analogue-to-digital converter of Linux industrial I/O, such as the HX711:
 * {@code in_voltage0_raw} (Documentation/ABI/testing/sysfs-bus-iio). Its scale comes from a
 * calibration with a known force.
 */
public final class IioLoadCell extends FileDevice<LoadCell.Load> implements LoadCell {
  private final Calibration calibration;

  /** The line between counts and force. */
  public record Calibration(
      @Variable(min = -1e12, max = 1e12, ifAbsent = 0)
          @Description("IIO: number in the file without load.")
          double zeroCount,
      @Variable(unit = "N", min = -1e9, max = 1e9, ifAbsent = 1)
          @Description("IIO: force per count, negative for a cell mounted the other way round.")
          double forcePerCount) {}

  /** Uses a file that may be absent. */
  public IioLoadCell(Path file, Calibration calibration) {
    super(List.of(file));
    this.calibration = calibration;
  }

  @Override
  protected Load reading(long nowMicros, double[] numbers) {
    return new Load(
        nowMicros, calibration.forcePerCount() * (numbers[0] - calibration.zeroCount()));
  }

  /** Provider of LOAD CELL = IIO. */
  public static final class Provider extends DeviceProvider<LoadCell> {
    public Provider() {
      super(LoadCell.class, "IIO");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Calibration.class);
    }

    @Override
    protected LoadCell open(String name, ServiceContext context) {
      return new IioLoadCell(
          IioPressure.file(context), context.configuration().settings(Calibration.class).get());
    }
  }
}
