package org.u2sa.interfaces.communication;

/** Thrown if a service connects with the name of another service of the same process. */
public final class NameTakenException extends CommunicationException {
  private static final long serialVersionUID = 1L;

  private final String name;

  NameTakenException(String name, String message) {
    super(message);
    this.name = name;
  }

  /** The name. */
  public String name() {
    return name;
  }
}
