package org.u2sa.scenarios.run;

/** What simulates the vehicle of a run. */
public interface Simulation extends AutoCloseable {
  /** Starts it, once the services listen. */
  default void start() throws InterruptedException {}

  /** What it is called in reports. */
  String name();

  /** What kind of vehicle it is, in a word, e.g. {@code aircraft}. */
  default String vehicle() {
    return "vehicle";
  }

  @Override
  default void close() {}

  /** A vehicle that a service of the system steps itself: nothing to start or end. */
  record Within(String name, String vehicle) implements Simulation {}
}
