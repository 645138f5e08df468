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
          @Description("How much longer the pulse is at 100 %.")
          double full) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final DoubleConsumer servo; // takes the length of its pulse [µs]

  /** Called by the launcher. Put your device in place of this one, which moves nothing. */
  public {{Name}}(ServiceContext context) {
    this(context, pulseMicros -> {});
  }

  /** With any servo, as tests have one. */
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
