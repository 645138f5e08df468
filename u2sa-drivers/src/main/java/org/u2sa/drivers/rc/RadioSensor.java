package org.u2sa.drivers.rc;

import java.util.Optional;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.Devices;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/**
 * Reports and counts takeovers by a pilot with the radio's switch. A multiplexer operated by the
 * same switch connects the pilot's channels to the servos. Out: manual-state.
 */
public final class RadioSensor extends PeriodicService {
  private static final double RATE_HZ = 50.0;
  private static final double TIMEOUT_S = 1.0; // without a frame from a connected receiver

  private static final Devices.Usual USUAL =
      new Devices.Usual("radio receiver", "RADIO", "CRSF", "serial:/dev/ttyUSB0?baud=420000");

  private record Variables(
      @Variable(min = 1, max = 16, ifAbsent = 5)
          @Description("Channel of the switch between automatic and manual.")
          int switchChannel,
      @Variable(ifAbsentText = "pilot") @Description("Name of the pilot in the manual-state.")
          String pilot) {}

  private final Variables variables = settings(Variables.class).get();
  private final RcSwitch radio = new RcSwitch(settings(RcSwitch.Variables.class).get());
  private final RadioReceiver receiver;
  private final DeviceReader<RadioReceiver.Pulses> reader;
  private boolean wasAutomatic; // whether it ever was: before that, no takeover is possible
  private boolean isManual;
  private boolean isTold; // a predecessor's last state may be manual
  private long takeovers;

  public RadioSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  public RadioSensor(ServiceContext context, RadioReceiver receiver) {
    this(context, Optional.of(receiver));
  }

  private RadioSensor(ServiceContext context, Optional<RadioReceiver> made) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "RadioSensor", RATE_HZ);
    registerPublisher(Channels.MANUAL_STATE);
    receiver = Devices.open(RadioReceiver.class, USUAL, context, getServiceName(), made);
    reader = new DeviceReader<>(this, "the radio receiver", receiver, TIMEOUT_S);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    reader.next(now).ifPresent(this::accept);
    RcSwitch.Position position = radio.position(now);
    remark("SWITCH", position.name());
    boolean isAutomatic = position == RcSwitch.Position.AUTOMATIC;
    wasAutomatic |= isAutomatic;
    if (wasAutomatic && isManual == isAutomatic) {
      isManual = !isAutomatic;
      takeovers += isManual ? 1 : 0;
      log(LogLevelEnum.WARN, (isManual ? "taken over by hand: " : "automatic again: ") + position);
      tell();
    } else if (isAutomatic && !isTold) {
      tell();
    }
  }

  private void tell() {
    isTold = true;
    confirm();
    publish(
        Channels.MANUAL_STATE,
        new ManualState().active(isManual).operator(variables.pilot()).takeovers(takeovers));
    remember();
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
    state.number("TAKEOVERS", takeovers);
  }

  @Override
  protected void takeOver(HandOver state) {
    wasAutomatic = state.flag("WAS AUTOMATIC");
    isManual = state.flag("IS MANUAL");
    takeovers = (long) state.number("TAKEOVERS").orElse(0.0);
    confirm();
  }

  @Override
  protected void release() {
    receiver.close();
  }
}
