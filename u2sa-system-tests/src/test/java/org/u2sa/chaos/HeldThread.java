package org.u2sa.chaos;

import com.sun.jdi.Bootstrap;
import com.sun.jdi.ThreadReference;
import com.sun.jdi.VMDisconnectedException;
import com.sun.jdi.VirtualMachine;
import com.sun.jdi.connect.AttachingConnector;
import com.sun.jdi.connect.Connector;
import com.sun.jdi.connect.IllegalConnectorArgumentsException;
import java.io.IOException;
import java.util.Map;

/**
 * One thread of another process that is held where it stands, as if its callback did not return;
 * the process' other threads go on. It goes on when this is closed.
 */
final class HeldThread implements AutoCloseable {
  private final VirtualMachine machine;

  private HeldThread(VirtualMachine machine) {
    this.machine = machine;
  }

  /**
   * @param process a Java process with a JDWP agent
   * @param threadName the thread to hold
   */
  static HeldThread hold(ProcessHandle process, String threadName)
      throws IOException, IllegalConnectorArgumentsException {
    AttachingConnector connector =
        Bootstrap.virtualMachineManager().attachingConnectors().stream()
            .filter(candidate -> candidate.name().equals("com.sun.jdi.ProcessAttach"))
            .findFirst()
            .orElseThrow();
    Map<String, Connector.Argument> arguments = connector.defaultArguments();
    arguments.get("pid").setValue(String.valueOf(process.pid()));
    VirtualMachine machine = connector.attach(arguments);
    for (ThreadReference thread : machine.allThreads()) {
      if (thread.name().equals(threadName)) {
        thread.suspend();
        return new HeldThread(machine);
      }
    }
    machine.dispose();
    throw new IOException("process " + process.pid() + " has no thread \"" + threadName + "\"");
  }

  @Override
  public void close() {
    try {
      machine.dispose();
    } catch (VMDisconnectedException e) {
      return; // the process was ended, which is what is hoped for
    }
  }
}
