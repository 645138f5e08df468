package org.u2sa.examples;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.safety.SafetyCheck;
import org.u2sa.core.safety.SafetyCheckProvider;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/** An extension's check: water in the hull, told by a sensor on a channel of its own. */
public final class LeakCheck implements SafetyCheck {
  /** Where the sensor in the bilge publishes the depth of water as z [m]. */
  public static final Channel<StateInformation> BILGE =
      Channel.every("bilge", StateInformation.TYPE);

  /** Found by the Safety Manager. */
  public static final class Provider implements SafetyCheckProvider {
    @Override
    public Collection<SafetyCheck> checks(Configurator configuration) {
      return List.of(new LeakCheck(configuration));
    }
  }

  private record Variables(
      @Variable(unit = "m", min = 0, max = 1, ifAbsent = 0.01)
          @Description("Water that counts as leak.")
          double leakDepth) {}

  private final Settings<Variables> tuning;
  private double depthM;

  private LeakCheck(Configurator configuration) {
    tuning = configuration.settings(Variables.class);
  }

  @Override
  public String name() {
    return "leak";
  }

  @Override
  public FailsafeAction defaultAction() {
    return FailsafeAction.RETURN;
  }

  @Override
  public Set<Channel<?>> channels() {
    return Set.of(BILGE);
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    depthM =
        ((StateInformation) message).z().orElseThrow(); // a sensor that says nothing is trouble
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    return depthM < tuning.get().leakDepth()
        ? Optional.empty()
        : Optional.of(Math.round(100.0 * depthM) + " cm of water");
  }
}
