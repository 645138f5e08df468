package org.u2sa.android.vehicle

import android.bluetooth.BluetoothManager
import android.content.Context
import android.hardware.usb.UsbManager
import java.io.File
import java.time.Instant
import org.u2sa.android.board.BluetoothConnection
import org.u2sa.android.board.BoardChoice
import org.u2sa.android.board.BoardLink
import org.u2sa.android.board.TcpConnection
import org.u2sa.android.board.UsbConnection
import org.u2sa.android.file.LogArchive
import org.u2sa.android.file.vehicleFiles
import org.u2sa.android.sensor.AndroidPhoneCamera
import org.u2sa.android.sensor.AndroidPhoneSensors
import org.u2sa.android.sensor.CameraHook
import org.u2sa.android.sensor.PhoneStateSensor
import org.u2sa.core.launch.LaunchOptions
import org.u2sa.core.launch.SystemFile
import org.u2sa.drivers.ioio.IoioService
import org.u2sa.interfaces.BadInputException
import org.u2sa.interfaces.time.Clock

private const val RUNS_KEPT = 20
private const val MICROS_PER_SECOND = 1_000_000L

/** Turns the user's choices into a launch for [VehicleHost], providing services with the phone's devices. */
internal class VehiclePlan(context: Context, private val settings: PhoneSettings, private val clock: Clock) {
    private val application = context.applicationContext
    private val files = vehicleFiles(application)
    private val link = boardLink() // null if the configuration file names the board connection

    /** Board connection, if a service uses one; a system without a board needs none. */
    @Volatile private var watched: BoardLink? = null

    /** Fault of the board connection; empty if none, or if a configuration file names the connection. */
    fun boardTrouble(): String = watched?.trouble.orEmpty()

    /** @throws BadInputException if a chosen file is missing or invalid */
    fun order(): VehicleHost.Order {
        val systemFile = files.system(settings.system)
        val mission = mission()
        LogArchive(files.logs).keepNewest(RUNS_KEPT)
        val condition = AndroidPhoneCondition(application)
        return VehicleHost.Order(
            systemFile = systemFile,
            logDirectory = File(files.logs, runName()),
            configure = {
                configure(it, mission)
                CameraHook(SystemFile.read(systemFile.toPath())).configure(it) { AndroidPhoneCamera(application, clock) }
            },
            cockpit = { Cockpit(it, condition, { watched?.connected() }, PhoneFailsafe(settings.lowBatteryPercent.toDouble())) },
            ended = condition::close,
        )
    }

    private fun runName() = Instant.ofEpochSecond(clock.micros() / MICROS_PER_SECOND).toString().replace(':', '-')

    private fun boardLink(): BoardLink? = when (val board = settings.board) {
        is BoardChoice.Bluetooth -> {
            val bluetooth = application.getSystemService(Context.BLUETOOTH_SERVICE) as? BluetoothManager
            BoardLink(board.toString()) { BluetoothConnection(bluetooth?.adapter, board.device, it) }
        }
        BoardChoice.Usb -> {
            val usb = application.getSystemService(Context.USB_SERVICE) as UsbManager
            BoardLink(board.toString()) { UsbConnection(usb, it) }
        }
        is BoardChoice.Tcp -> BoardLink(board.toString()) { TcpConnection(board.host, board.port, it) }
        BoardChoice.Configured -> null
    }

    private fun configure(options: LaunchOptions, mission: File?) {
        options.making(PhoneStateSensor::class.java) { PhoneStateSensor(it, AndroidPhoneSensors(application, clock)) }
        link?.let { way ->
            options.making(IoioService::class.java) {
                watched = way
                IoioService(it, way)
            }
        }
        if (!settings.network) {
            options.override("CommunicationManager", "BROKER", "none")
        }
        if (mission != null) {
            options.override("MissionManager", "MISSION", mission.path)
            options.override("SafetyManager", "FENCE", "") // the configured fence belongs to its own mission
        }
    }

    /** Null for the configured mission. */
    private fun mission(): File? {
        val chosen = settings.mission
        return if (chosen.isEmpty()) null else files.mission(chosen) ?: throw BadInputException("the mission \"$chosen\" no longer exists")
    }
}
