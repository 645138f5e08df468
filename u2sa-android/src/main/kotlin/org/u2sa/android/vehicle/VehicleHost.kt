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
 * Starts and ends the system that a file lists, with a [Cockpit] in it, one at a time and on a thread of its own: no call here
 * waits. Knows nothing of Android, so it is tested as it is.
 *
 * A process that dies while a vehicle runs leaves RUNNING in the [RunStateFile]. The next one begins as [Phase.CRASHED], which
 * runs nothing: what moves again, moves because somebody said so.
 */
class VehicleHost(
    private val stateFile: RunStateFile,
    private val clock: Clock,
    private val onChange: (State) -> Unit,
) : AutoCloseable {
    /** Where the vehicle is in its life. */
    enum class Phase { STOPPED, STARTING, RUNNING, STOPPING, FAILED, CRASHED }

    /** @property words what went wrong; empty if nothing */
    data class State(val phase: Phase, val words: String = "") {
        /** Whether anything of the vehicle may be alive. */
        val isActive: Boolean get() = phase == Phase.STARTING || phase == Phase.RUNNING || phase == Phase.STOPPING
    }

    /**
     * What is to be started.
     *
     * @property systemFile the list of its services
     * @property logDirectory where their logs are written
     * @property configure sets what the file cannot say
     * @property cockpit makes the phone's place in it
     * @property ended called when all services have ended, to let go of what [configure] opened
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
    private var run: Run? = null // touched by that thread only

    /** The cockpit of the running vehicle; null if none runs. */
    @Volatile
    var cockpit: Cockpit? = null
        private set

    /** From any thread. */
    @Volatile
    var state: State = if (stateFile.saysRunning()) State(Phase.CRASHED) else State(Phase.STOPPED)
        private set

    /** Starts a vehicle, unless one runs. What fails is in [state]; then nothing runs. */
    fun start(order: Order) = enqueue { if (run == null) begin(order) else order.ended() }

    /** Says that nothing was started, and why. */
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
        } catch (e: RuntimeException) { // a service's own constructor
            abandon(order, system, e.toString())
        } catch (e: LinkageError) { // a class that this phone's Android lacks
            abandon(order, system, e.toString())
        }
    }

    private fun options(order: Order, file: SystemFile): LaunchOptions {
        val logs = order.logDirectory.toPath()
        val options = LaunchOptions()
            .clock(clock)
            .logDirectory(logs)
            .making(Recorder::class.java) { Recorder(it, facts(file, logs)) }
            .override("SafetyManager", "ARM AT START", false) // on a phone somebody arms by hand
        order.configure(options)
        return options
    }

    /** What a recorder of the system file attaches. */
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

    /** Ends the vehicle that runs; also makes known that somebody saw that one had crashed or failed. */
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

    /** Ends what runs, then the thread; does not wait for it. A crash that nobody saw stays known. */
    override fun close() {
        if (state.phase != Phase.CRASHED) {
            stop()
        }
        thread.shutdown()
    }

    /** Waits until all has ended after [close]. */
    @Throws(InterruptedException::class)
    fun awaitEnd(seconds: Long): Boolean = thread.awaitTermination(seconds, TimeUnit.SECONDS)
}
