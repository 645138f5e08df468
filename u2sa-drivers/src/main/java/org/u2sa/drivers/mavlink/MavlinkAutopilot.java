package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.BatteryStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.device.DeviceWatch;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.PendingBytes;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * A MAVLink autopilot (ArduPilot or PX4): a state sensor, and actuators chosen by the variable
 * COMMANDS. In: actuation, emergency-stop, arming-state. Out: sensed-state, power, actuators,
 * announced as lost without heartbeats.
 */
public final class MavlinkAutopilot extends ProprioceptiveSensor implements ActuatorOwner {
  private static final double STEPS_PER_S = 50.0;
  private static final double FULL_PERCENT = 100.0;

  private final ByteLink link;
  private final DeviceWatch watch;
  private final MavlinkStream stream;
  private final AutopilotPeer peer;
  private final AutopilotState state;
  private final AutopilotPower power;
  private final CommandForm form;
  private final CommandedActuators commands;
  private final AutopilotCommands output;
  private final PendingBytes pending = new PendingBytes();
  private final LineLimit lines = new LineLimit();
  private final String
      positionName; // separate from attitude, because a newer message replaces an unread one
  private final long silentMicros; // time without heartbeats until the autopilot counts as lost
  private long lostMicros = Long.MIN_VALUE; // when it counts as lost, if a successor receives none
  private boolean isWaitSaid;

  public MavlinkAutopilot(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given link and ignores CONNECTION. */
  public MavlinkAutopilot(ServiceContext context, ByteLink link) {
    this(context, Optional.of(link));
  }

  private MavlinkAutopilot(ServiceContext context, Optional<ByteLink> given) {
    super(context, "MavlinkAutopilot", STEPS_PER_S);
    registerPublisher(Channels.POWER);
    MavlinkVariables variables = settings(MavlinkVariables.class).get();
    form = variables.form(this);
    Set<String> names = new LinkedHashSet<>();
    form.axes().forEach(axis -> names.add(axis.name()));
    commands = new CommandedActuators(this, names, this::stopNow);
    output =
        new AutopilotCommands(
            form, 1.0 / variables.commandRate(), variables.neutralTime(), this::send);
    if (context.isRestart()) {
      output.inherit();
    }
    silentMicros = Clock.micros(variables.heartbeatTimeout());
    stream = new MavlinkStream(variables.ownSystem(), variables.ownComponent());
    peer = new AutopilotPeer(variables.autopilotSystem(), variables.stateRate(), this::send);
    state = new AutopilotState(variables.staleAfter());
    positionName = sensorName() + SensorParts.POSITION;
    power = new AutopilotPower(sensorName());
    link = given.orElseGet(() -> ByteLinks.of(context));
    watch = new DeviceWatch(this, "the autopilot", link, variables.heartbeatTimeout());
  }

  /** Returns whether the link accepted it; a rejected message is soon repeated or outdated. */
  private boolean send(Object message) {
    return link.write(stream.encode(message));
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    List<ActuatorAnnouncement> actuators = new ArrayList<>();
    for (CommandForm.Axis axis : form.axes()) {
      actuators.add(
          new ActuatorAnnouncement()
              .actuatorName(axis.name())
              .minimum(axis.minimum())
              .maximum(FULL_PERCENT)
              .effect(axis.effect()));
    }
    return actuators;
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
  }

  private void stopNow() {
    if (commands.isStopped()) {
      output.endInNeutral();
    }
    peer.target().ifPresent(target -> output.stop(target, clock().micros()));
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    if (watch.look(now)) {
      stream.reset();
      state.reset();
    }
    pending.read(
        link, (bytes, length) -> stream.accept(bytes, length, message -> take(message, now)));
    watch.malformed(stream.malformed(), stream.lastRefusal());
    boolean isHeard = watch.isHeard(now);
    commands.available(isHeard ? FULL_PERCENT : 0.0);
    peer.step(isHeard, now);
    if (isHeard || now >= lostMicros || !commands.isCommanded()) {
      peer.target()
          .ifPresent(
              target ->
                  output.step(
                      target,
                      name -> isHeard ? commands.percentage(name) : OptionalDouble.empty(),
                      now));
    }
    sayWait();
    commands.step(nowS);
  }

  private void sayWait() {
    if (output.isWaiting() && !isWaitSaid) {
      trouble("commands wait for the autopilot's heading (ATTITUDE)");
    }
    isWaitSaid = output.isWaiting();
  }

  private void take(MavlinkStream.Received message, long now) {
    if (!peer.isFrom(message)) {
      return; // a radio, a gimbal, another vehicle on the same link
    }
    if (message.payload() instanceof Heartbeat heartbeat) {
      watch.heard(now);
      peer.take(heartbeat, line -> told(line, now), line -> troubled(line, now));
    } else if (message.payload() instanceof Statustext text) {
      peer.take(text, line -> told(line, now), line -> troubled(line, now));
    } else if (message.payload() instanceof Attitude attitude) {
      peer.streams(now);
      StateInformation said = state.attitude(attitude, now).sensorName(sensorName());
      form.hear(attitude, now); // only now: an implausible heading must not become the target
      publish(Channels.SENSED_STATE, said);
    } else if (message.payload() instanceof GlobalPositionInt position) {
      state
          .position(position, now)
          .ifPresent(each -> publish(Channels.SENSED_STATE, each.sensorName(positionName)));
    } else if (message.payload() instanceof GpsRawInt gps) {
      state.accept(gps, now);
    } else if (message.payload() instanceof SysStatus status) {
      power.of(status).ifPresent(this::publishPower);
    } else if (message.payload() instanceof BatteryStatus status) {
      power.of(status).ifPresent(this::publishPower);
    }
  }

  private void told(String line, long now) {
    lines.pass(line, now, this::log);
  }

  private void troubled(String line, long now) {
    lines.pass(line, now, this::trouble);
  }

  private void publishPower(BatteryState battery) {
    publish(Channels.POWER, battery);
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    output.handOver(state, clock().micros());
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    output.takeOver(state);
    lostMicros = clock().micros() + silentMicros; // until then the last command still holds
  }

  /** The autopilot holds the last command until the successor takes over. */
  @Override
  protected void releaseToSuccessor() {
    link.close();
  }

  @Override
  protected void release() {
    try {
      peer.target().ifPresent(target -> output.end(target, clock().micros()));
    } finally {
      commands.withdraw();
      link.close();
    }
  }
}
