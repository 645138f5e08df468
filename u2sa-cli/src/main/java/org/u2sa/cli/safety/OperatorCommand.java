package org.u2sa.cli.safety;

import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ListeningTime;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code u2sa operator}: sends operator heartbeats and shows the vehicle's safety state. */
@Command(
    name = "operator",
    description = {
      "Act as a vehicle's operator until Ctrl-C.",
      "",
      "Sends an operator heartbeat every second and shows each change of arming state, failsafe and services. Once a vehicle "
          + "has received a heartbeat, it treats silence as loss of the operator."
    })
public final class OperatorCommand extends BaseCommand {
  private static final double INTERVAL_S = 1.0;
  private static final String ARMING = "arming";

  @Mixin private RemoteSystem remote;

  @Mixin private ListeningTime time;

  private final Map<String, String> shown = new LinkedHashMap<>(); // guarded by itself

  @Override
  public Integer call() throws InterruptedException {
    try (RemoteLink link = remote.connect();
        Clock.Waiter waiter = link.clock().newWaiter("operator")) {
      link.listen(Channels.ARMING_STATE, this::show);
      link.listen(Channels.FAILSAFE, this::show);
      link.listen(Channels.CONDITIONS, this::show);
      long end = time.end(link.clock().micros());
      long due = link.clock().micros();
      while (due < end) {
        link.publish(
            Channels.OPERATOR,
            new OperatorHeartbeat().operator(Operator.name()).interval(INTERVAL_S));
        due += Clock.micros(INTERVAL_S);
        while (link.clock().micros() < Math.min(due, end)) {
          waiter.await(Math.min(due, end));
        }
      }
      return isHeard() ? ExitCode.DONE : nobody(link);
    }
  }

  private boolean isHeard() {
    synchronized (shown) {
      return shown.containsKey(ARMING);
    }
  }

  private int nobody(RemoteLink link) throws InterruptedException {
    print(
        link.systemId() + ": no Safety Manager answers: the vehicle does not monitor its operator");
    remote.otherSystems(link).ifPresent(out()::println);
    return ExitCode.FAILED;
  }

  private void show(ArmingState state) {
    show(
        ARMING,
        state.armed() ? "armed" : "not armed: " + state.reasons(),
        state.armed() + " " + state.reasons().size());
  }

  private void show(FailsafeState state) {
    String line =
        state.action() + (state.causes().isEmpty() ? "" : " because of " + state.causes());
    show("failsafe", line, state.action() + " " + state.causes().size());
  }

  private void show(ServiceCondition condition) {
    String line =
        condition.condition()
            + (condition.reason().isEmpty() ? "" : ": " + condition.reason())
            + (condition.action().isEmpty() ? "" : ", " + condition.action());
    show("service " + condition.serviceName(), line, condition.condition() + condition.action());
  }

  /**
   * Shows a line unless it differs from the last one shown only in numbers. Called on the
   * transport's thread.
   */
  private void show(String subject, String line, String gist) {
    synchronized (shown) {
      if (!gist.equals(shown.put(subject, gist))) {
        print(subject + ": " + line);
      }
    }
  }
}
