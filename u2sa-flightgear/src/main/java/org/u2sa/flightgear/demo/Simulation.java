package org.u2sa.flightgear.demo;

/** What simulates the aircraft of a flight, where that is not the Simulator service itself. */
interface Simulation extends AutoCloseable {
  /** Starts it, once the services listen. */
  void start() throws InterruptedException;

  /** What it is called in reports. */
  String name();

  @Override
  void close();

  /** The aircraft that the Simulator service steps itself: nothing to start. */
  static Simulation embedded() {
    return new Simulation() {
      @Override
      public void start() {
        // the Simulator service made it
      }

      @Override
      public String name() {
        return "embedded Cessna 172";
      }

      @Override
      public void close() {
        // nothing was started
      }
    };
  }
}
