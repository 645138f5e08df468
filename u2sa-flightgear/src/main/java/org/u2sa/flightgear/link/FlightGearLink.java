package org.u2sa.flightgear.link;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Link to FlightGear, or to its stand-in, over the generic protocol: one TCP connection in each
 * direction (thesis 4.5.2.1). The constructor opens the listening port. Start FlightGear after it,
 * because FlightGear connects only once.
 *
 * <p>A reading's {@code measuredAtMicros} follows FlightGear's clock, so time steps are those of
 * the flight. It is never later than the arrival, keeps its age after a network stall, increases
 * with each reading, and follows the run's clock if FlightGear loses time or runs faster than real
 * time (one second between readings is then several seconds of flight). There are no new readings
 * while FlightGear is paused. {@code now − measuredAtMicros} is therefore the age of the reading
 * and never negative.
 *
 * <p>A reading counts as connected while complete, plausible lines arrive. It becomes disconnected
 * 1 s after the last line, or immediately when FlightGear closes the connection. A cut link
 * recovers automatically: the control connection reconnects with exponential back-off; the output
 * connection, which FlightGear never reopens itself, is restored through the property server if a
 * port is given. FlightGear holds the last controls during an outage. For real time only: the link
 * never waits for a simulated clock.
 *
 * <p>While FlightGear starts its engine, throttle and mixture are limited to values that keep the
 * engine running, whatever is written.
 *
 * <p>Thread-safe. The link's own thread is a daemon and ends with {@link #close}.
 */
public final class FlightGearLink implements AircraftLink {
  private static final long END_MS = 2_000;

  private final Troubles troubles;
  private final FlightGearThread thread;

  /**
   * Opens the listening port.
   *
   * @param clock the run's clock, in real time
   * @throws org.u2sa.interfaces.communication.CommunicationException if the out-port is in use; the
   *     message names the remedy
   */
  public FlightGearLink(FlightGearAddress address, Clock clock) {
    troubles = new Troubles(clock);
    thread = new FlightGearThread(address, clock, troubles);
    troubles.event("waiting for FlightGear on " + address.bindHost() + ":" + thread.port());
    thread.start();
  }

  /**
   * Opens the listening port.
   *
   * @param propertyPort 0 for none
   * @throws org.u2sa.interfaces.communication.CommunicationException if the out-port is in use; the
   *     message names the remedy
   */
  public FlightGearLink(String host, int outPort, int inPort, int propertyPort, Clock clock) {
    this(FlightGearAddress.of(host, outPort, inPort, propertyPort), clock);
  }

  /** The port on which this link listens for FlightGear. */
  public int outPort() {
    return thread.port();
  }

  /** Number of malformed lines refused. */
  public long refusedLines() {
    return troubles.refusedLines();
  }

  @Override
  public AircraftReading read(long nowMicros) {
    FlightGearThread.Seen seen = thread.seen();
    boolean fresh = nowMicros - seen.lastLineMicros() <= OutChannel.SILENCE_MICROS;
    return seen.alive() && fresh ? seen.reading() : seen.reading().lost();
  }

  @Override
  public void write(ControlInputs controls) {
    thread.want(controls);
  }

  @Override
  public String trouble() {
    return troubles.take();
  }

  /** Closes the connections after sending the controls written last. Takes less than a second. */
  @Override
  public void close() {
    thread.end();
    try {
      thread.join(END_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the thread ends without being waited for
    }
  }
}
