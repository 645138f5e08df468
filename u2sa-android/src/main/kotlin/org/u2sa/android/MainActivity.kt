package org.u2sa.android

import android.app.Activity
import android.app.AlertDialog
import android.content.ClipData
import android.content.Intent
import android.net.Uri
import android.os.Bundle
import android.os.Handler
import android.os.Looper
import android.provider.Settings.ACTION_APPLICATION_DETAILS_SETTINGS
import android.view.Menu
import android.view.MenuItem
import android.widget.Toast
import org.u2sa.android.file.LogArchive
import org.u2sa.android.file.LogProvider
import org.u2sa.android.file.vehicleFiles
import org.u2sa.android.screen.Choice
import org.u2sa.android.screen.Orders
import org.u2sa.android.screen.Panel
import org.u2sa.android.screen.Permissions
import org.u2sa.android.screen.SettingsActivity
import org.u2sa.android.text.Text
import org.u2sa.android.screen.VehicleConnection
import org.u2sa.android.sensor.CameraHook
import org.u2sa.android.vehicle.PhoneSettings
import org.u2sa.android.vehicle.VehicleHost
import org.u2sa.android.vehicle.VehicleSnapshot
import org.u2sa.core.launch.SystemFile
import org.u2sa.interfaces.BadInputException

private const val REFRESH_MS = 200L

/** Main screen: vehicle status, position, and buttons to start and stop it. */
class MainActivity : Activity(), Orders {
    private val main = Handler(Looper.getMainLooper())
    private val connection = VehicleConnection(this)
    private lateinit var settings: PhoneSettings
    private lateinit var choice: Choice
    private lateinit var panel: Panel
    private var dialog: AlertDialog? = null
    private val refresh = Runnable { refresh() }

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        settings = PhoneSettings(this)
        choice = Choice(this, settings, ::tell)
        panel = Panel(this, this)
        setContentView(panel.root)
    }

    override fun onStart() {
        super.onStart()
        connection.open()
        refresh()
    }

    override fun onStop() {
        main.removeCallbacks(refresh)
        connection.close()
        super.onStop()
    }

    override fun onDestroy() {
        dialog?.dismiss() // a dialog must not outlive its activity
        super.onDestroy()
    }

    private fun refresh() {
        val service = connection.service
        val state = service?.state ?: VehicleHost.State(VehicleHost.Phase.STARTING)
        panel.show(state, service?.snapshot ?: VehicleSnapshot(), service?.boardTrouble?.invoke().orEmpty(), choice.words())
        main.removeCallbacks(refresh)
        main.postDelayed(refresh, REFRESH_MS)
    }

    private fun missingPermissions() = Permissions(this).missing(settings.board, looks())

    /** Whether the chosen system uses the camera. File errors are reported at start. */
    private fun looks(): Boolean = try {
        CameraHook(SystemFile.read(vehicleFiles(this).system(settings.system).toPath())).isWanted
    } catch (e: BadInputException) {
        false
    }

    override fun start() {
        val missing = missingPermissions()
        if (missing.isEmpty()) {
            connection.startVehicle()
            return
        }
        dialog = AlertDialog.Builder(this)
            .setTitle(Text.PERMISSION_TITLE.of(this))
            .setMessage(missing.joinToString("\n\n") { it.why.of(this) })
            .setPositiveButton(Text.PERMISSION_ASK.of(this)) { _, _ ->
                requestPermissions(missing.flatMap { it.permissions }.toTypedArray(), START_REQUEST)
            }
            .show()
    }

    /** Starts with the permissions granted; a board GPS, for example, needs no phone location. */
    override fun onRequestPermissionsResult(request: Int, permissions: Array<String>, results: IntArray) {
        if (request != START_REQUEST || results.isEmpty()) {
            return // request was interrupted
        }
        val missing = missingPermissions()
        if (missing.isNotEmpty()) {
            explain(missing)
        }
        if (Permissions.Need.BLUETOOTH !in missing) {
            connection.startVehicle()
        }
    }

    private fun explain(missing: List<Permissions.Need>) {
        dialog = AlertDialog.Builder(this)
            .setTitle(Text.PERMISSION_TITLE.of(this))
            .setMessage(Text.PERMISSION_MISSING.of(this, missing.joinToString(", ") { it.short.of(this) }))
            .setPositiveButton(Text.PERMISSION_SETTINGS.of(this)) { _, _ ->
                startActivity(Intent(ACTION_APPLICATION_DETAILS_SETTINGS, Uri.fromParts("package", packageName, null)))
            }
            .setNegativeButton(Text.PERMISSION_ASK.of(this), null)
            .show()
    }

    override fun stop() {
        connection.service?.stop()
    }

    override fun arm(wanted: Boolean) {
        if (!wanted) {
            connection.service?.arm(false)
            return
        }
        dialog = AlertDialog.Builder(this)
            .setMessage(Text.ARM_QUESTION.of(this))
            .setPositiveButton(Text.YES.of(this)) { _, _ -> connection.service?.arm(true) }
            .setNegativeButton(Text.NO.of(this), null)
            .show()
    }

    override fun emergencyStop() {
        connection.service?.emergencyStop()
    }

    override fun clearEmergencyStop() {
        connection.service?.clearEmergencyStop()
    }

    override fun onCreateOptionsMenu(menu: Menu): Boolean {
        MENU.forEachIndexed { i, text -> menu.add(Menu.NONE, i, i, text.of(this)) }
        return true
    }

    override fun onOptionsItemSelected(item: MenuItem): Boolean {
        val chosen = MENU.getOrNull(item.itemId) ?: return super.onOptionsItemSelected(item)
        when {
            chosen == Text.MENU_LOGS -> shareLogs()
            connection.service?.state?.isActive != false -> tell(Text.MENU_ONLY_STOPPED.of(this))
            chosen == Text.MENU_MISSION -> choice.pickMission()
            chosen == Text.MENU_SYSTEM -> dialog = choice.pickSystem()
            else -> startActivity(Intent(this, SettingsActivity::class.java))
        }
        return true
    }

    override fun onActivityResult(request: Int, result: Int, data: Intent?) {
        data?.data?.takeIf { result == RESULT_OK }?.let { choice.picked(request, it) }
    }

    private fun shareLogs() {
        if (LogArchive(vehicleFiles(this).logs).isEmpty()) {
            tell(Text.LOGS_NONE.of(this))
            return
        }
        val uri = LogProvider.uri(this)
        val send = Intent(Intent.ACTION_SEND).apply {
            type = LogProvider.MIME_TYPE
            putExtra(Intent.EXTRA_STREAM, uri)
            putExtra(Intent.EXTRA_SUBJECT, Text.LOGS_SUBJECT.of(this@MainActivity))
            clipData = ClipData.newRawUri("", uri) // grants read permission
            addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
        }
        startActivity(Intent.createChooser(send, Text.MENU_LOGS.of(this)))
    }

    private fun tell(words: String) = Toast.makeText(this, words, Toast.LENGTH_LONG).show()

    private companion object {
        const val START_REQUEST = 1
        val MENU = listOf(Text.MENU_MISSION, Text.MENU_SYSTEM, Text.MENU_SETTINGS, Text.MENU_LOGS)
    }
}
