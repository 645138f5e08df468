package org.u2sa.flightgear.link;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * FlightGear, or the stand-in, over its generic protocol: two TCP connections, one each way (thesis
 * 4.5.2.1). It listens from the constructor on, so FlightGear is started after it: FlightGear
 * connects once and never again.
 *
 * <p>A reading's {@code measuredAtMicros} follows FlightGear's own time, so that time steps are
 * those of the flight; it is never later than the arrival, keeps its age if the network stalled,
 * grows with each reading, and follows the run's clock where FlightGear loses time or runs faster
 * (then a second between readings is several of flight). No new readings come while FlightGear is
 * paused. So {@code now − measuredAtMicros} is the age of the information and never negative.
 *
 * <p>A reading is connected while whole, plausible lines come: false 1 s after the last one, and at
 * once when FlightGear closes. A link that was cut comes back by itself: controls are reconnected
 * with growing pauses; lines, which FlightGear never reconnects, over its property server if a port
 * is given. FlightGear keeps the last controls meanwhile. For real time only: it never waits for a
 * simulated clock.
 *
 * <p>While FlightGear starts its engine, throttle and mixture are kept where the engine survives,
 * whatever is written.
 *
 * <p>Safe for several threads. The link's own thread is a daemon and ends with {@link #close}.
 */
public final class FlightGearLink implements AircraftLink {
  private static final long END_MS = 2_000;

  private final Troubles troubles;
  private final FlightGearThread thread;

  /**
   * Begins to listen.
   *
   * @param clock the run's clock, in real time
   * @throws org.u2sa.interfaces.communication.CommunicationException if the out-port is taken; the
   *     message says what to do
   */
  public FlightGearLink(FlightGearAddress address, Clock clock) {
    troubles = new Troubles(clock);
    thread = new FlightGearThread(address, clock, troubles);
    troubles.event("waiting for FlightGear on " + address.bindHost() + ":" + thread.port());
    thread.start();
  }

  /**
   * Begins to listen.
   *
   * @param propertyPort 0 is none
   * @throws org.u2sa.interfaces.communication.CommunicationException if the out-port is taken; the
   *     message says what to do
   */
  public FlightGearLink(String host, int outPort, int inPort, int propertyPort, Clock clock) {
    this(FlightGearAddress.of(host, outPort, inPort, propertyPort), clock);
  }

  /** The port on which it listens for FlightGear. */
  public int outPort() {
    return thread.port();
  }

  /** How many lines of FlightGear were refused as malformed. */
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

  /**
   * Ends the connections, after the controls that were written last have been sent. Takes at most
   * some tenths of a second.
   */
  @Override
  public void close() {
    thread.end();
    try {
      thread.join(END_MS);
    } catch (InterruptedException e) {
      Thread.currentThread()
          .interrupt(); // the thread ends by itself; an interrupt asks not to wait
    }
  }
}
