package org.u2sa.core.launch;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Creates a service from a class name in a system file or an order. */
public final class ServiceFactory {
  private ServiceFactory() {}

  /**
   * Finds the class of an entry in a system file.
   *
   * @throws BadInputException if the class does not exist or is not a service; names file, line and
   *     class
   */
  static Constructor<? extends U2SAService> constructor(SystemFile.Entry entry) {
    try {
      return constructor(entry.className());
    } catch (BadInputException e) {
      throw entry.element().error(e.getMessage());
    }
  }

  /**
   * Finds a class without initialising it.
   *
   * @throws BadInputException if the class does not exist or is not a service; names the class
   */
  static Constructor<? extends U2SAService> constructor(String className) {
    try {
      Class<?> found = Class.forName(className, false, ServiceFactory.class.getClassLoader());
      if (!U2SAService.class.isAssignableFrom(found)) {
        throw new BadInputException(
            "class \"" + className + "\" is not a service: it does not extend U2SAService");
      }
      return found.asSubclass(U2SAService.class).getConstructor(ServiceContext.class);
    } catch (ClassNotFoundException e) {
      throw new BadInputException(
          "class \""
              + className
              + "\" is not on the class path; expected the full name of a service class",
          e);
    } catch (NoSuchMethodException e) {
      throw new BadInputException(
          "class \""
              + className
              + "\" cannot be started: expected a public constructor (ServiceContext)",
          e);
    } catch (LinkageError e) {
      throw new BadInputException("class \"" + className + "\" cannot be loaded: " + e, e);
    }
  }

  /**
   * Creates the service of an entry in a system file.
   *
   * @throws BadInputException if it cannot be created; names file, line and class
   */
  static U2SAService create(SystemFile.Entry entry, ServiceContext context) {
    constructor(entry);
    try {
      return create(entry.className(), context);
    } catch (NotMadeException e) {
      throw entry.element().error(e.getMessage());
    }
  }

  /** Thrown if the class, not its code, is at fault. */
  private static final class NotMadeException extends BadInputException {
    private static final long serialVersionUID = 1L;

    NotMadeException(String message, Throwable cause) {
      super(message, cause);
    }
  }

  /**
   * Creates a service.
   *
   * @throws BadInputException if the class does not exist or is not a service; names the class
   * @throws RuntimeException what its constructor threw
   */
  public static U2SAService create(String className, ServiceContext context) {
    try {
      return constructor(className).newInstance(context);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause; // thrown by the service: invalid variable, missing device
      }
      if (e.getCause() instanceof Error cause) {
        throw cause;
      }
      throw new NotMadeException(className + " failed: " + e.getCause(), e);
    } catch (InstantiationException e) {
      throw new NotMadeException(
          "class \"" + className + "\" is abstract; expected one of its implementations", e);
    } catch (IllegalAccessException e) {
      throw new NotMadeException("class \"" + className + "\" is not public", e);
    }
  }
}
