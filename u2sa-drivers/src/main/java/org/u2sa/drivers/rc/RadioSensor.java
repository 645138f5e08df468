package org.u2sa.drivers.rc;

import java.util.Optional;
import java.util.OptionalLong;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.Devices;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/**
 * Reports and counts takeovers by a pilot with the radio's switch. A multiplexer operated by the
 * same switch connects the pilot's channels to the servos. Out: manual-state.
 *
 * <p>Only the switch gives and takes control: a lost radio, which no pilot may have switched off,
 * leaves it where it is, and is reported.
 */
public final class RadioSensor extends PeriodicService {
  private static final double RATE_HZ = 50.0;
  private static final double TIMEOUT_S = 1.0; // without a frame, or without a switch position
  private static final double REPEAT_S = 0.5; // while the pilot flies
  private static final String AUTOMATIC = "AUTOMATIC";

  private static final Devices.Usual USUAL =
      new Devices.Usual("radio receiver", "RADIO", "CRSF", "serial:/dev/ttyUSB0?baud=420000");

  private record Variables(
      @Variable(min = 1, max = 16, ifAbsent = 5)
          @Description("Channel of the switch between automatic and manual.")
          int switchChannel,
      @Variable(ifAbsentText = "pilot") @Description("Name of the pilot in the manual-state.")
          String pilot,
      @Variable(
              oneOf = {"AS BEFORE", AUTOMATIC},
              ifAbsentText = "AS BEFORE")
          @Description(
              "Whose commands the multiplexer passes on when the radio is lost: AS BEFORE, or AUTOMATIC, those of the services.")
          String multiplexerAtLoss) {}

  private final Variables variables = settings(Variables.class).get();
  private final RcSwitch radio;
  private final RadioReceiver receiver;
  private final DeviceReader<RadioReceiver.Pulses> reader;
  private boolean wasAutomatic; // whether it ever was: before that, no takeover is possible
  private boolean isManual;
  private boolean isTold; // a predecessor's last state may be manual
  private OptionalLong heardMicros = OptionalLong.empty(); // last time with a switch position
  private boolean isLost;
  private long takeovers;
  private double repeatDueS;

  public RadioSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  public RadioSensor(ServiceContext context, RadioReceiver receiver) {
    this(context, Optional.of(receiver));
  }

  private RadioSensor(ServiceContext context, Optional<RadioReceiver> made) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "RadioSensor", RATE_HZ);
    registerPublisher(Channels.MANUAL_STATE);
    RcSwitch.Variables tuning = settings(RcSwitch.Variables.class).get();
    // Noise may look like a frame with a right checksum, but not several times in a row.
    radio = new RcSwitch(tuning, tuning.confirmations());
    receiver = Devices.open(RadioReceiver.class, USUAL, context, getServiceName(), made);
    reader = new DeviceReader<>(this, "the radio receiver", receiver, TIMEOUT_S);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    reader.next(now).ifPresent(this::accept);
    RcSwitch.Position position = radio.position(now);
    remark("SWITCH", position.name());
    boolean wasLost = isLost;
    listen(position, now);
    boolean isAutomatic = position == RcSwitch.Position.AUTOMATIC;
    wasAutomatic |= isAutomatic;
    boolean fallsBack = isLost && variables.multiplexerAtLoss().equals(AUTOMATIC);
    boolean isGivenBack = isManual && (isAutomatic || fallsBack);
    boolean isTakenOver = !isManual && wasAutomatic && position == RcSwitch.Position.MANUAL;
    if (isGivenBack || isTakenOver) {
      isManual = isTakenOver;
      takeovers += isManual ? 1 : 0;
      log(LogLevelEnum.WARN, (isManual ? "taken over by hand: " : "automatic again: ") + position);
      tell();
    } else if (isAutomatic && !isTold) {
      tell();
    } else if (isManual && nowS >= repeatDueS) {
      say(); // lest control systems conclude that this service has ended
    }
    if (isLost != wasLost) {
      tellLoss(position);
    }
  }

  private void listen(RcSwitch.Position position, long now) {
    if (position != RcSwitch.Position.LOST) {
      boolean isFirst = heardMicros.isEmpty();
      heardMicros = OptionalLong.of(now);
      if (isFirst) {
        remember();
      }
    }
    isLost = heardMicros.isPresent() && Clock.seconds(now - heardMicros.getAsLong()) > TIMEOUT_S;
  }

  private void tellLoss(RcSwitch.Position position) {
    String who = isManual ? "control stays with the pilot" : "automatic control continues";
    remark(ManualState.LOSS_REMARK, isLost ? who : "");
    if (isLost) {
      trouble("the pilot's radio is lost: " + who);
    } else {
      log(LogLevelEnum.WARN, "the pilot's radio is back: " + position);
    }
  }

  private void tell() {
    isTold = true;
    confirm();
    say();
    remember();
  }

  private void say() {
    repeatDueS = nowS() + REPEAT_S;
    publish(
        Channels.MANUAL_STATE,
        new ManualState().active(isManual).operator(variables.pilot()).takeovers(takeovers));
  }

  private void confirm() {
    remark(ManualState.REMARK, isManual ? variables.pilot() : "");
  }

  private void accept(RadioReceiver.Pulses pulses) {
    boolean isThere = pulses.widthsS().size() >= variables.switchChannel();
    double width = isThere ? pulses.widthsS().get(variables.switchChannel() - 1) : Double.NaN;
    radio.accept(width, clock().micros());
  }

  @Override
  protected void handOver(HandOver state) {
    state.flag("WAS AUTOMATIC", wasAutomatic).flag("IS MANUAL", isManual);
    state.flag("HEARD", heardMicros.isPresent()).number("TAKEOVERS", takeovers);
  }

  @Override
  protected void takeOver(HandOver state) {
    wasAutomatic = state.flag("WAS AUTOMATIC");
    isManual = state.flag("IS MANUAL");
    if (state.flag("HEARD")) {
      heardMicros = OptionalLong.of(clock().micros()); // time to connect
    }
    takeovers = (long) state.number("TAKEOVERS").orElse(0.0);
    confirm();
  }

  @Override
  protected void release() {
    receiver.close();
  }
}
