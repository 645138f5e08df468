package org.u2sa.sim.ground;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.sim.ioio.Pins;
import org.u2sa.sim.ioio.PulseTrain;
import org.u2sa.sim.sensor.SpartonDevice;
import org.u2sa.sim.sensor.UartTransmitter;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.VoltmeterModel;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/**
 * The hardware of thesis 4.6.3 behind the pins of an IOIO: a vehicle, its motor controllers, a
 * u-blox GPS, a Sparton compass, a battery, and a radio receiver whose switch decides by a
 * multiplexer who drives, the transmitter's sticks or the IOIO.
 *
 * <p>Its time is that of {@link #advance} and begins with the first call. What it tells of the
 * truth may be asked for on any thread.
 */
public final class MiniMolle implements Pins {
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
  private final EscInput first = new EscInput();
  private final EscInput second = new EscInput();
  private long beginUs = -1; // not yet; other times count from it
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

  /** Builds one that stands in this world. */
  public static MiniMolleBuilder in(World world) {
    return new MiniMolleBuilder(world);
  }

  @Override
  public void advance(long nowMicros) {
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

  /** The truth of the last tick. */
  public GroundState state() {
    return state;
  }

  /** The same in the terms of all vehicles. */
  public VehicleTruth truth() {
    return truth;
  }

  /** Every touch of an obstacle so far. */
  public List<ContactWatch.Contact> contacts() {
    return List.copyOf(contacts);
  }

  /** What reached the motors in the last tick, from whoever drives. */
  public DriveCommand command() {
    return command;
  }

  /** What the run has in store. */
  public List<DrivingHazard> hazards() {
    return hazards.all();
  }

  /**
   * Which pin of the IOIO leads where, and how the battery is divided down. The board receives at
   * {@code …Receive} what the device sends.
   *
   * @param first pulses to the left motor's controller, or to that of the only motor
   * @param second pulses to the right motor's controller, or to the steering servo
   * @param radioSwitch pulses of the radio receiver's switch channel
   * @param battery analog input
   * @param dividerRatio voltage at that input by the battery's
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

  /**
   * Where a motor controller, or a servo, takes its pulses: 1000 to 2000 µs about 1500, and a
   * fail-safe after 0.1 s without any. A new width counts from its next pulse on.
   */
  private static final class EscInput {
    private static final double NEUTRAL_S = 1.5e-3;
    private static final double HALF_RANGE_S = 0.5e-3;
    private static final double SHORTEST_S = 0.8e-3; // others are noise
    private static final double LONGEST_S = 2.2e-3;
    private static final long FAILSAFE_US = 100_000;
    private static final double US_PER_S = 1e6;

    private PulseTrain pulses = PulseTrain.NONE;
    private boolean seen;
    private long lastUs;
    private long nextUs;
    private double command = Double.NaN;

    /** Pulses that come from now on. */
    void take(PulseTrain train, long nowUs) {
      if (!pulses.present() && train.present()) {
        nextUs = nowUs + Math.round(train.widthS() * US_PER_S);
      }
      pulses = train;
    }

    /** The command that holds now, −1…1; NaN if pulses are missing. */
    double command(long nowUs) {
      if (pulses.present() && nowUs >= nextUs) {
        nextUs = nowUs + Math.round(pulses.periodS() * US_PER_S);
        if (pulses.widthS() >= SHORTEST_S && pulses.widthS() <= LONGEST_S) {
          double wanted = (pulses.widthS() - NEUTRAL_S) / HALF_RANGE_S;
          command = Math.max(-1.0, Math.min(1.0, wanted));
          seen = true;
          lastUs = nowUs;
        }
      }
      if (!seen || nowUs - lastUs > FAILSAFE_US) {
        seen = false;
        command = Double.NaN;
      }
      return command;
    }
  }
}
