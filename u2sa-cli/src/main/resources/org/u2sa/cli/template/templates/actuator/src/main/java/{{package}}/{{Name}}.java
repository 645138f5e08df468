package {{package}};

import java.util.function.DoubleConsumer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/** Moves a servo. In: actuation of its ACTUATOR NAME. Out: actuators. */
public final class {{Name}} extends Actuator {
  private record Variables(
      @Variable(unit = "us", min = 500, max = 2500, ifAbsent = 1500) @Description("Pulse at 0 %.")
          double neutral,
      @Variable(unit = "us", min = -1000, max = 1000, ifAbsent = 500)
          @Description("Increase of the pulse width at 100 %.")
          double full) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final DoubleConsumer servo; // receives the pulse width [µs]

  /** Called by the launcher. Replace this dummy with your device. */
  public {{Name}}(ServiceContext context) {
    this(context, pulseMicros -> {});
  }

  {{Name}}(ServiceContext context, DoubleConsumer servo) {
    super(context, "{{Name}}");
    this.servo = servo;
  }

  @Override
  protected void actuate(double percentage) {
    servo.accept(tuning.get().neutral() + percentage / 100.0 * tuning.get().full());
  }

  @Override
  protected void neutral() {
    servo.accept(tuning.get().neutral());
  }
}
