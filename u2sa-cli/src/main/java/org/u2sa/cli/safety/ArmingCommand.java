package org.u2sa.cli.safety;

import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Asks the Safety Manager to arm or disarm, and prints its answer. */
public abstract class ArmingCommand extends BaseCommand {
  private static final int REPETITIONS = 30; // of an order to disarm, one a second

  private final boolean arm;
  @Mixin private RemoteSystem remote;

  private ArmingCommand(boolean arm) {
    this.arm = arm;
  }

  /** {@code u2sa arm}: arms a vehicle, or prints why it cannot be armed. */
  @Command(
      name = "arm",
      description = {
        "Arm a vehicle, or report why it cannot be armed.",
        "",
        "Its Safety Manager checks services, state, battery, fence, mission and actuators. If "
            + "the vehicle is armed, this ends a RETURN or LAND whose cause is gone."
      })
  public static final class Arm extends ArmingCommand {
    public Arm() {
      super(true);
    }
  }

  /** {@code u2sa disarm}: disarms a vehicle. */
  @Command(
      name = "disarm",
      description = {
        "Disarm a vehicle, even in mid-air.",
        "",
        "Actuators whose variable REQUIRES ARMING is true go neutral; failsafes no longer act. "
            + "Without an answer the order is repeated for 30 s, because a Safety Manager that "
            + "restarts meanwhile has not heard it. 'u2sa estop' needs no Safety Manager."
      })
  public static final class Disarm extends ArmingCommand {
    public Disarm() {
      super(false);
    }
  }

  @Override
  public final Integer call() throws InterruptedException {
    // Disarming is obeyed whatever its age, and must not wait for the vehicle's time.
    try (RemoteLink link = arm ? remote.connectForOrders() : remote.connect()) {
      Optional<ArmingState> answer = answer(link);
      if (answer.isEmpty()) {
        print(link.systemId() + ": no Safety Manager answered" + (arm ? within(link) : ""));
        print("  " + (arm ? Unanswered.EXPIRING : Unanswered.LASTING));
        remote.otherSystems(link).ifPresent(out()::println);
        return ExitCode.FAILED;
      }
      boolean armed = answer.get().armed();
      List<String> reasons = arm ? answer.get().reasons() : List.of();
      boolean isRefused = armed != arm || !reasons.isEmpty(); // or armed before, and not again
      print(link.systemId() + (armed ? ": armed" : ": not armed"));
      reasons.forEach(reason -> print("  " + reason));
      return isRefused ? ExitCode.FAILED : ExitCode.DONE;
    }
  }

  private Optional<ArmingState> answer(RemoteLink link) throws InterruptedException {
    String id = UUID.randomUUID().toString();
    AtomicReference<ArmingState> answer = new AtomicReference<>();
    link.listen(
        Channels.ARMING_STATE,
        state -> {
          if (state.requestId().filter(id::equals).isPresent()) {
            answer.set(state);
          }
        });
    order(link, id);
    link.await(() -> answer.get() != null, link.timeoutS());
    if (answer.get() == null && !arm) {
      print(link.systemId() + ": no Safety Manager answered" + within(link) + ": repeating");
    }
    for (int i = 0; !arm && answer.get() == null && i < REPETITIONS; i++) {
      order(link, id); // a Safety Manager that has restarted never heard the first one
      link.await(() -> answer.get() != null, 1.0);
    }
    return Optional.ofNullable(answer.get());
  }

  private void order(RemoteLink link, String id) {
    link.publish(
        Channels.ARMING, new ArmCommand().requestId(id).arm(arm).operator(Operator.name()));
  }

  private static String within(RemoteLink link) {
    return " within " + link.timeoutS() + " s";
  }
}
