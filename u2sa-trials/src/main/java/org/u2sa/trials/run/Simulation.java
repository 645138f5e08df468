package org.u2sa.trials.run;

/** Simulation of a run's vehicle. */
public interface Simulation extends AutoCloseable {
  /** Starts the simulation; called once the services have subscribed. */
  default void start() throws InterruptedException {}

  /** Name in reports. */
  String name();

  /** Kind of vehicle in one word, e.g. {@code aircraft}. */
  default String vehicle() {
    return "vehicle";
  }

  @Override
  default void close() {}

  /** This simulation, with another resource to close at its end. */
  default Simulation and(Runnable end) {
    Simulation first = this;
    return new Simulation() {
      @Override
      public void start() throws InterruptedException {
        first.start();
      }

      @Override
      public String name() {
        return first.name();
      }

      @Override
      public String vehicle() {
        return first.vehicle();
      }

      @Override
      public void close() {
        end.run();
        first.close();
      }
    };
  }

  /** A simulation stepped by a service of the system: nothing to start or stop. */
  record Within(String name, String vehicle) implements Simulation {}
}
