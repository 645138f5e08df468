package org.u2sa.android.vehicle

import java.io.File
import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.TimeUnit
import org.u2sa.core.launch.LaunchOptions
import org.u2sa.core.launch.RunningSystem
import org.u2sa.core.launch.SystemFile
import org.u2sa.interfaces.BadInputException
import org.u2sa.interfaces.communication.CommunicationException
import org.u2sa.interfaces.configuration.XmlConfiguration
import org.u2sa.interfaces.time.Clock
import org.u2sa.recorder.Recorder
import org.u2sa.recorder.RecordingFacts
import org.u2sa.recorder.RunFiles
import org.u2sa.service.ServiceContext

/**
 * Starts and stops a system with a [Cockpit] in it, one at a time, on its own thread; calls do not block. Free of Android
 * classes, so it is testable.
 *
 * If the process dies while a vehicle runs, RUNNING remains in the [RunStateFile]. The next process starts as [Phase.CRASHED] and stays idle until the user starts the vehicle again.
 */
class VehicleHost(
    private val stateFile: RunStateFile,
    private val clock: Clock,
    private val onChange: (State) -> Unit,
) : AutoCloseable {
    /** Life-cycle phase. */
    enum class Phase { STOPPED, STARTING, RUNNING, STOPPING, FAILED, CRASHED }

    /** @property words fault; empty if none */
    data class State(val phase: Phase, val words: String = "") {
        /** Whether any part of the vehicle may be running. */
        val isActive: Boolean get() = phase == Phase.STARTING || phase == Phase.RUNNING || phase == Phase.STOPPING
    }

    /**
     * A system to start.
     *
     * @property systemFile system file
     * @property logDirectory folder for logs
     * @property configure applies settings the file cannot contain
     * @property cockpit creates the cockpit
     * @property ended called when all services have ended, to release what [configure] opened
     */
    class Order(
        val systemFile: File,
        val logDirectory: File,
        val configure: (LaunchOptions) -> Unit,
        val cockpit: (ServiceContext) -> Cockpit,
        val ended: () -> Unit = {},
    )

    private class Run(val order: Order, val system: RunningSystem, val cockpit: Cockpit)

    private val thread: ExecutorService = Executors.newSingleThreadExecutor { Thread(it, "u2sa-vehicle-host") }
    private var run: Run? = null // confined to that thread

    /** Cockpit of the running vehicle; null if none runs. */
    @Volatile
    var cockpit: Cockpit? = null
        private set

    /** Current state. Thread-safe. */
    @Volatile
    var state: State = if (stateFile.saysRunning()) State(Phase.CRASHED) else State(Phase.STOPPED)
        private set

    /** Starts a vehicle unless one is running. On failure, [state] reports it and no service runs. */
    fun start(order: Order) = enqueue { if (run == null) begin(order) else order.ended() }

    /** Records that nothing was started, and why. */
    fun refuse(words: String) = enqueue {
        if (run == null) {
            become(State(Phase.FAILED, words))
        }
    }

    private fun begin(order: Order) {
        become(State(Phase.STARTING))
        var system: RunningSystem? = null
        try {
            stateFile.running()
            val file = SystemFile.read(order.systemFile.toPath())
            system = RunningSystem.start(file, options(order, file))
            val made = cockpitOf(system, order)
            run = Run(order, system, made)
            cockpit = made
            become(State(Phase.RUNNING))
        } catch (e: BadInputException) {
            abandon(order, system, e.message.orEmpty())
        } catch (e: CommunicationException) {
            abandon(order, system, e.message.orEmpty())
        } catch (e: RuntimeException) { // thrown by a service's constructor
            abandon(order, system, e.toString())
        } catch (e: LinkageError) { // a class missing on this Android version
            abandon(order, system, e.toString())
        }
    }

    private fun options(order: Order, file: SystemFile): LaunchOptions {
        val logs = order.logDirectory.toPath()
        val options = LaunchOptions()
            .clock(clock)
            .logDirectory(logs)
            .making(Recorder::class.java) { Recorder(it, facts(file, logs)) }
            .override("SafetyManager", "ARM AT START", false) // on a phone, arming is manual
        order.configure(options)
        return options
    }

    /** Attachments for a recorder of the system. */
    private fun facts(file: SystemFile, logs: Path): RecordingFacts {
        val facts = RecordingFacts()
        RunFiles(facts).system(file.file(), file.configurations()).logs(logs)
        return facts
    }

    private fun cockpitOf(system: RunningSystem, order: Order): Cockpit {
        val context = system.contextFor(XmlConfiguration.inMemory(Cockpit.NAME, emptyMap<String, Any>()))
        try {
            return order.cockpit(context).apply { start() }
        } catch (e: RuntimeException) {
            context.abandon()
            throw e
        }
    }

    private fun abandon(order: Order, system: RunningSystem?, words: String) {
        var all = words
        try {
            system?.close()
            stateFile.stopped()
        } catch (e: RuntimeException) {
            all += "; ${e.message}"
        }
        order.ended()
        become(State(Phase.FAILED, all))
    }

    /** Stops the running vehicle; also acknowledges a crash or failure. */
    fun stop() = enqueue { end() }

    private fun end() {
        var words = ""
        run?.let {
            become(State(Phase.STOPPING))
            cockpit = null
            it.cockpit.kill()
            try {
                it.system.close()
            } catch (e: RuntimeException) {
                words = "ending: $e"
            }
            it.order.ended()
            run = null
        }
        try {
            stateFile.stopped()
        } catch (e: BadInputException) {
            words = e.message.orEmpty()
        }
        become(if (words.isEmpty()) State(Phase.STOPPED) else State(Phase.FAILED, words))
    }

    private fun become(next: State) {
        state = next
        onChange(next)
    }

    private fun enqueue(action: () -> Unit) {
        try {
            thread.execute(action)
        } catch (e: RejectedExecutionException) {
            become(State(Phase.FAILED, "the application is ending: $e"))
        }
    }

    /** Stops the vehicle, then the thread, without waiting. An unacknowledged crash stays recorded. */
    override fun close() {
        if (state.phase != Phase.CRASHED) {
            stop()
        }
        thread.shutdown()
    }

    /** Waits for termination after [close]. */
    @Throws(InterruptedException::class)
    fun awaitEnd(seconds: Long): Boolean = thread.awaitTermination(seconds, TimeUnit.SECONDS)
}
