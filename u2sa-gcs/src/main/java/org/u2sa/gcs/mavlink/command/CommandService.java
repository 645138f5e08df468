package org.u2sa.gcs.mavlink.command;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.SetMode;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders.Answer;

/**
 * Command protocol for one station (mavlink.io/en/services/command). Every command is acknowledged;
 * a repeated command is not executed again while the vehicle executes the first.
 */
public final class CommandService {
  private final GroundStation station;
  private final MessageCommands messages;
  private final VehicleCommands vehicle;
  private final Identity identity;
  private final Set<Command> pending = new HashSet<>();

  public CommandService(
      GroundStation station, MessageCommands messages, VehicleCommands vehicle, Identity identity) {
    this.station = station;
    this.messages = messages;
    this.vehicle = vehicle;
    this.identity = identity;
  }

  /** Handles a message; false if it does not belong to this protocol. */
  @SuppressWarnings("deprecation") // stations still send these
  public boolean handle(Object message, Sender from) {
    if (message instanceof CommandLong command) {
      obey(Command.of(command, identity), from);
    } else if (message instanceof CommandInt command) {
      obey(Command.of(command), from);
    } else if (message instanceof SetMode request) {
      vehicle.mode(request.customMode(), from.system(), answer("mode not changed", result -> {}));
    } else {
      return false;
    }
    return true;
  }

  private void obey(Command command, Sender from) {
    Optional<MavResult> immediate = messages.obey(command);
    if (immediate.isPresent()) {
      acknowledge(command.id(), immediate.get(), from);
      return;
    }
    if (!pending.add(command)) {
      return; // repeated before the first was answered
    }
    boolean isKnown =
        vehicle.obey(
            command,
            from.system(),
            answer(
                "command " + name(command.id()) + " refused",
                result -> {
                  if (result != MavResult.MAV_RESULT_IN_PROGRESS) {
                    pending.remove(command);
                  }
                  acknowledge(command.id(), result, from);
                }));
    if (!isKnown) {
      pending.remove(command);
      acknowledge(command.id(), MavResult.MAV_RESULT_UNSUPPORTED, from);
    }
  }

  /** Receives the result of a command. */
  @FunctionalInterface
  private interface Outcome {
    void is(MavResult result);
  }

  private Answer answer(String ifRefused, Outcome outcome) {
    return new Answer() {
      @Override
      public void done(boolean accepted, String text) {
        end(
            accepted ? MavResult.MAV_RESULT_ACCEPTED : MavResult.MAV_RESULT_DENIED,
            ifRefused + ": " + text);
      }

      @Override
      public void failed(String text) {
        end(MavResult.MAV_RESULT_FAILED, ifRefused.replace(" refused", " failed") + ": " + text);
      }

      private void end(MavResult result, String ifNotAccepted) {
        if (result != MavResult.MAV_RESULT_ACCEPTED) {
          station.text(MavSeverity.MAV_SEVERITY_ERROR, ifNotAccepted);
        }
        outcome.is(result);
      }

      @Override
      public void inProgress() {
        outcome.is(MavResult.MAV_RESULT_IN_PROGRESS);
      }
    };
  }

  private static String name(int id) {
    MavCmd known = EnumValue.create(MavCmd.class, id).entry();
    return known == null ? Integer.toString(id) : known.name().substring("MAV_CMD_".length());
  }

  private void acknowledge(int id, MavResult result, Sender to) {
    station.send(
        CommandAck.builder()
            .command(EnumValue.create(MavCmd.class, id))
            .result(result)
            .targetSystem(to.system())
            .targetComponent(to.component())
            .build());
  }
}
