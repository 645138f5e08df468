package org.u2sa.scenarios.run;

/** What simulates the vehicle of a run, where that is not a service itself. */
public interface Simulation extends AutoCloseable {
  /** Starts it, once the services listen. */
  void start() throws InterruptedException;

  /** What it is called in reports. */
  String name();

  /** What kind of vehicle it is, in a word, e.g. {@code aircraft}. */
  String vehicle();

  @Override
  void close();

  /**
   * A vehicle that a service of the system steps itself: nothing to start.
   *
   * @param name see {@link #name}
   * @param vehicle see {@link #vehicle}
   */
  static Simulation within(String name, String vehicle) {
    return new Simulation() {
      @Override
      public void start() {
        // the service made it
      }

      @Override
      public String name() {
        return name;
      }

      @Override
      public String vehicle() {
        return vehicle;
      }

      @Override
      public void close() {
        // nothing was started
      }
    };
  }
}
