package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.Manifest
import android.app.Activity
import android.bluetooth.BluetoothManager
import android.content.Context
import android.content.Intent
import android.os.Bundle
import android.text.InputType
import android.view.View
import android.view.ViewGroup
import android.widget.Button
import android.widget.CheckBox
import android.widget.EditText
import android.widget.LinearLayout
import android.widget.RadioButton
import android.widget.RadioGroup
import android.widget.ScrollView
import android.widget.TextView
import org.u2sa.android.board.BoardChoice
import org.u2sa.android.vehicle.PhoneSettings
import org.u2sa.interfaces.BadInputException

private const val PAD_DP = 16
private const val TOUCH_DP = 48 // Android's minimum for what is touched
private const val BLUETOOTH_REQUEST = 1

/** Settings of the board connection and the phone's failsafe. Changes take effect at the next start. */
class SettingsActivity : Activity() {
    private lateinit var settings: PhoneSettings
    private lateinit var boards: RadioGroup
    private lateinit var tcp: EditText
    private lateinit var battery: EditText
    private lateinit var trouble: TextView

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        title = Text.SETTINGS.of(this)
        settings = PhoneSettings(this)
        show()
    }

    private fun show() {
        boards = RadioGroup(this)
        tcp = EditText(this).apply {
            hint = Text.SETTINGS_TCP_HINT.of(context)
            inputType = InputType.TYPE_CLASS_TEXT or InputType.TYPE_TEXT_VARIATION_URI
            contentDescription = Text.SETTINGS_BOARD_TCP.of(context)
            (settings.board as? BoardChoice.Tcp)?.let { setText(it.toString().removePrefix(TCP)) }
        }
        battery = EditText(this).apply {
            inputType = InputType.TYPE_CLASS_NUMBER
            contentDescription = Text.SETTINGS_BATTERY.of(context)
            setText(settings.lowBatteryPercent.toString())
        }
        trouble = TextView(this).apply { accessibilityLiveRegion = View.ACCESSIBILITY_LIVE_REGION_ASSERTIVE }
        val column = LinearLayout(this).apply {
            orientation = LinearLayout.VERTICAL
            val pad = (PAD_DP * resources.displayMetrics.density).toInt()
            setPadding(pad, pad, pad, pad)
        }
        listBoards()
        column.addView(label(Text.SETTINGS_BOARD))
        listOf(boards, tcp, bluetoothButton()).forEach(column::addView)
        column.addView(label(Text.SETTINGS_BATTERY))
        column.addView(battery)
        column.addView(check(Text.SETTINGS_NETWORK, settings.network) { settings.network = it })
        column.addView(check(Text.SETTINGS_SPEAK, settings.speak) { settings.speak = it })
        column.addView(trouble)
        setContentView(ScrollView(this).apply { addView(column) }, ViewGroup.LayoutParams(-1, -1))
    }

    private fun label(text: Text) = TextView(this).apply {
        this.text = text.of(context)
        isAccessibilityHeading = true
    }

    private fun check(text: Text, now: Boolean, changed: (Boolean) -> Unit) = CheckBox(this).apply {
        this.text = text.of(context)
        isChecked = now
        setOnCheckedChangeListener { _, checked -> changed(checked) }
    }

    private fun listBoards() {
        board(BoardChoice.Configured.toString(), Text.SETTINGS_BOARD_CONFIGURED.of(this))
        board(BoardChoice.Usb.toString(), Text.SETTINGS_BOARD_USB.of(this))
        val known = pairedAdapters()
        known.forEach { (address, name) ->
            board(BoardChoice.Bluetooth(address).toString(), Text.SETTINGS_BOARD_BLUETOOTH.of(this, "$name ($address)"))
        }
        (settings.board as? BoardChoice.Bluetooth)?.takeIf { it.device !in known }?.let {
            board(it.toString(), Text.SETTINGS_BOARD_BLUETOOTH.of(this, it.device)) // previously chosen, no longer paired
        }
        board(TCP, Text.SETTINGS_BOARD_TCP.of(this))
        val chosen = settings.board
        val tag = if (chosen is BoardChoice.Tcp) TCP else chosen.toString()
        boards.findViewWithTag<RadioButton>(tag)?.let { boards.check(it.id) }
    }

    private fun board(tag: String, words: String) = boards.addView(
        RadioButton(this).apply {
            id = View.generateViewId()
            this.tag = tag
            text = words
            minHeight = (TOUCH_DP * resources.displayMetrics.density).toInt()
        },
    )

    /** Device names by hardware address; empty without the permission. */
    private fun pairedAdapters(): Map<String, String> {
        if (!Permissions(this).mayUseBluetooth()) {
            return emptyMap()
        }
        val adapter = (getSystemService(Context.BLUETOOTH_SERVICE) as? BluetoothManager)?.adapter
        return adapter?.bondedDevices.orEmpty().associate { it.address to (it.name ?: it.address) }.toSortedMap()
    }

    private fun bluetoothButton() = Button(this).apply {
        isAllCaps = false
        if (Permissions(context).mayUseBluetooth()) {
            text = Text.SETTINGS_PAIR.of(context)
            setOnClickListener { startActivity(Intent(android.provider.Settings.ACTION_BLUETOOTH_SETTINGS)) }
        } else {
            text = Text.SETTINGS_BLUETOOTH_PERMISSION.of(context)
            setOnClickListener { requestPermissions(arrayOf(Manifest.permission.BLUETOOTH_CONNECT), BLUETOOTH_REQUEST) }
        }
    }

    override fun onRequestPermissionsResult(request: Int, permissions: Array<String>, results: IntArray) = show()

    override fun onPause() {
        save()
        super.onPause()
    }

    private fun save() {
        val tag = boards.findViewById<View>(boards.checkedRadioButtonId)?.tag as String? ?: return
        try {
            settings.board = BoardChoice.parse(if (tag == TCP) TCP + tcp.text.toString().trim() else tag)
        } catch (e: BadInputException) {
            trouble.text = Text.SETTINGS_WRONG.of(this, e.message.orEmpty())
            android.widget.Toast.makeText(this, trouble.text, android.widget.Toast.LENGTH_LONG).show()
        }
        battery.text.toString().toIntOrNull()?.let { settings.lowBatteryPercent = it }
    }

    private companion object {
        const val TCP = "tcp:"
    }
}
