package org.u2sa.messages.command;

/**
 * Setters common to all commands with a quantity, which return the command itself.
 *
 * @param <S> the command
 */
abstract class CommandSetters<S extends ActuatorCommand> extends ActuatorCommand {
  @Override
  public S actuatorName(String name) {
    super.actuatorName(name);
    return self();
  }

  @Override
  public S expiry(double seconds) {
    super.expiry(seconds);
    return self();
  }

  @SuppressWarnings("unchecked") // self type: a command extends the setters of its own class
  private S self() {
    return (S) this;
  }
}
