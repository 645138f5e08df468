package org.u2sa.sim.ground;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.u2sa.sim.ioio.Pins;
import org.u2sa.sim.ioio.PulseTrain;
import org.u2sa.sim.ioio.ServoInput;
import org.u2sa.sim.sensor.SpartonDevice;
import org.u2sa.sim.sensor.UartTransmitter;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.VoltmeterModel;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/**
 * The hardware of thesis 4.6.3 behind the pins of an IOIO: a vehicle, its motor controllers, a
 * u-blox GPS, a Sparton compass, a battery, and a radio receiver whose switch channel drives a
 * multiplexer between the transmitter's sticks and the IOIO.
 *
 * <p>Time advances by {@link #advance} and starts at its first call. Accessors of the truth are
 * thread-safe.
 */
public final class MiniMolle implements Pins, RunningVehicle {
  private static final long TICK_US = 1_000_000L / GroundVehicle.TICKS_PER_SECOND;
  private static final double TICK_S = 1.0 / GroundVehicle.TICKS_PER_SECOND;
  private static final double US_PER_S = 1e6;
  private static final PulseTrain AUTOMATIC = new PulseTrain(1.9e-3, 0.02);
  private static final PulseTrain BY_HAND = new PulseTrain(1.1e-3, 0.02);

  private final Wiring wiring;
  private final GroundVehicle vehicle;
  private final World world;
  private final UbloxReceiver gps;
  private final SpartonDevice compass;
  private final VoltmeterModel voltmeter;
  private final HazardPlay hazards;
  private final ServoInput first = new ServoInput(false);
  private final ServoInput second = new ServoInput(false);
  private long beginUs = -1; // −1: not started; other times are relative to it
  private long tickUs;
  private long nowUs;
  private final List<ContactWatch.Contact> contacts = new CopyOnWriteArrayList<>();
  private final ContactWatch watch = new ContactWatch(contacts::add);
  private volatile GroundState state;
  private volatile VehicleTruth truth;
  private volatile DriveCommand command = DriveCommand.none();

  MiniMolle(MiniMolleBuilder parts) {
    wiring = parts.wiring;
    vehicle = parts.vehicle;
    world = parts.world;
    gps = parts.gps();
    compass = parts.compass();
    voltmeter = parts.voltmeter();
    hazards = new HazardPlay(parts.hazards, vehicle, world);
    state = vehicle.state();
    truth = vehicle.truth();
  }

  /** Creates the hardware in this world. */
  public static MiniMolleBuilder in(World world) {
    return new MiniMolleBuilder(world);
  }

  @Override
  public synchronized void advance(long nowMicros) {
    if (beginUs < 0) {
      beginUs = nowMicros;
      sense(0);
    }
    gps.line().forget(nowUs);
    compass.line().forget(nowUs);
    nowUs = nowMicros - beginUs;
    while (nowUs - tickUs >= TICK_US) {
      tickUs += TICK_US;
      tick(tickUs);
    }
  }

  private void tick(long micros) {
    double timeS = micros / US_PER_S;
    double a = first.command(micros);
    double b = second.command(micros);
    DriveCommand told = hazards.master(timeS, a, b);
    hazards.act(timeS);
    vehicle.step(told, TICK_S);
    command = told;
    state = vehicle.state();
    truth = vehicle.truth();
    watch.look(vehicle, truth);
    if (micros >= gps.nextUs() || micros >= compass.nextUs()) {
      sense(micros);
    }
  }

  private void sense(long micros) {
    GroundState s = state;
    gps.advance(micros, hazards.received(truth), hazards.gpsBlocked(micros / US_PER_S));
    compass.advance(
        micros, truth, hazards.field(s.eastM(), s.northM(), s.leftMotorA(), s.rightMotorA()));
  }

  @Override
  public void driven(int pin, PulseTrain pulses) {
    if (pin == wiring.first()) {
      first.take(pulses, nowUs);
    } else if (pin == wiring.second()) {
      second.take(pulses, nowUs);
    }
  }

  @Override
  public void released(int pin) {
    driven(pin, PulseTrain.NONE);
  }

  @Override
  public void transmitted(int pin, int baud, byte[] bytes, int length) {
    if (pin == wiring.gpsTransmit()) {
      gps.accept(nowUs, baud, bytes, length);
    } else if (pin == wiring.compassTransmit()) {
      compass.accept(nowUs, baud, bytes, length);
    }
  }

  @Override
  public int received(int pin, int baud, byte[] buffer) {
    if (pin == wiring.gpsReceive()) {
      return take(gps.line(), baud, buffer);
    }
    return pin == wiring.compassReceive() ? take(compass.line(), baud, buffer) : 0;
  }

  private int take(UartTransmitter line, int baud, byte[] buffer) {
    return line.take(nowUs, baud, buffer);
  }

  @Override
  public double volts(int pin) {
    return pin == wiring.battery() ? voltmeter.sample(state.batteryV()) : 0.0;
  }

  @Override
  public PulseTrain pulses(int pin) {
    if (pin != wiring.radioSwitch()) {
      return PulseTrain.NONE;
    }
    double timeS = state.timeS();
    if (hazards.radioSilent(timeS)) {
      return PulseTrain.NONE;
    }
    return hazards.sticks(timeS).isPresent() ? BY_HAND : AUTOMATIC;
  }

  /** Ground truth of the last tick. */
  public GroundState state() {
    return state;
  }

  /** Ground truth of the last tick, as the general vehicle state. */
  public VehicleTruth truth() {
    return truth;
  }

  /** {@inheritDoc} Only the board steps it. */
  @Override
  public VehicleTruth at(long nowMicros) {
    return truth;
  }

  @Override
  public synchronized <T> T read(long nowMicros, Function<SimulatedVehicle, T> property) {
    return property.apply(vehicle);
  }

  @Override
  public SimulatedVehicle vehicle() {
    return vehicle;
  }

  @Override
  public List<ContactWatch.Contact> contacts() {
    return List.copyOf(contacts);
  }

  /** Motor commands of the last tick, from whichever source was selected. */
  public DriveCommand command() {
    return command;
  }

  /**
   * IOIO pin assignment and battery divider. {@code …Receive} is the board's RX pin.
   *
   * @param first pulses to the left motor's controller, or to that of the only motor
   * @param second pulses to the right motor's controller, or to the steering servo
   * @param radioSwitch pulses of the radio receiver's switch channel
   * @param battery analog input
   * @param dividerRatio voltage at that input relative to the battery voltage
   */
  public record Wiring(
      int gpsReceive,
      int gpsTransmit,
      int compassReceive,
      int compassTransmit,
      int first,
      int second,
      int radioSwitch,
      int battery,
      double dividerRatio) {
    /** The wiring of docs/drivers: GPS 6 and 7, compass 13 and 14, motors 10 and 11, 35, 40. */
    public static Wiring standard() {
      return new Wiring(6, 7, 13, 14, 10, 11, 35, 40, 0.2);
    }
  }
}
