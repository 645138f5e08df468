package org.u2sa.gcs.safety;

import java.io.PrintWriter;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ArmCommand;
import org.u2sa.messages.contract.ArmingState;

/** Asks a Safety Manager to arm or to disarm, and says what it answered. */
final class ArmingOrder {
  private ArmingOrder() {}

  /** Gives the order. Returns the command's exit code. */
  static int give(RemoteSystem remote, boolean arm, PrintWriter out) throws InterruptedException {
    try (RemoteLink link = remote.connect()) {
      Optional<ArmingState> answer = answer(link, arm);
      int code = say(link, arm, answer, out);
      if (answer.isEmpty()) {
        remote.otherSystems(link).ifPresent(out::println);
      }
      return code;
    }
  }

  private static int say(
      RemoteLink link, boolean arm, Optional<ArmingState> answer, PrintWriter out) {
    if (answer.isEmpty()) {
      out.println(
          link.systemId() + ": no Safety Manager answered within " + link.timeoutS() + " s");
      return ExitCode.FAILED;
    }
    boolean armed = answer.get().armed();
    out.println(link.systemId() + (armed ? ": armed" : ": not armed"));
    if (arm) {
      answer.get().reasons().forEach(reason -> out.println("  " + reason));
    }
    return armed == arm ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static Optional<ArmingState> answer(RemoteLink link, boolean arm)
      throws InterruptedException {
    String id = UUID.randomUUID().toString();
    AtomicReference<ArmingState> answer = new AtomicReference<>();
    link.listen(
        Channels.ARMING_STATE,
        message -> {
          if (message instanceof ArmingState state
              && state.requestId().filter(id::equals).isPresent()) {
            answer.set(state);
          }
        });
    link.publish(
        Channels.ARMING, new ArmCommand().requestId(id).arm(arm).operator(RemoteSystem.operator()));
    link.await(() -> answer.get() != null, link.timeoutS());
    return Optional.ofNullable(answer.get());
  }
}
