package org.u2sa.core.launch;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Makes a service from the class name in a system file. */
final class ServiceFactory {
  private ServiceFactory() {}

  /**
   * Finds the class.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is no such class or it is no service;
   *     names file, line and class
   */
  static Constructor<? extends U2SAService> constructor(SystemFile.Entry entry) {
    XmlElement element = entry.element();
    try {
      Class<?> found = Class.forName(entry.className());
      if (!U2SAService.class.isAssignableFrom(found)) {
        throw element.error(
            "class \"" + entry.className() + "\" is no service: it does not extend U2SAService");
      }
      return found.asSubclass(U2SAService.class).getConstructor(ServiceContext.class);
    } catch (ClassNotFoundException e) {
      throw element.error(
          "class \""
              + entry.className()
              + "\" is not on the class path; expected the full name of a service class");
    } catch (NoSuchMethodException e) {
      throw element.error(
          "class \""
              + entry.className()
              + "\" cannot be started: expected a public constructor (ServiceContext)");
    }
  }

  static U2SAService create(SystemFile.Entry entry, ServiceContext context) {
    XmlElement element = entry.element();
    try {
      return constructor(entry).newInstance(context);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause; // the service's own words: a wrong variable, a missing device
      }
      if (e.getCause() instanceof Error cause) {
        throw cause;
      }
      throw new IllegalStateException(
          element.error(entry.className() + " failed: " + e.getCause()).getMessage(), e);
    } catch (InstantiationException e) {
      throw element.error(
          "class \"" + entry.className() + "\" is abstract; expected one of its implementations");
    } catch (IllegalAccessException e) {
      throw element.error("class \"" + entry.className() + "\" is not public");
    }
  }
}
