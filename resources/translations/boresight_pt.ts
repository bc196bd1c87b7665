<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt">
<context>
    <name>Axes</name>
    <message>
        <source>azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EL</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ClientsPermission</name>
    <message>
        <source>select a client first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is latched, press &quot;Reset stop&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mount is locked to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whoever sends last moves the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has the control</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DrivesPermission</name>
    <message>
        <source>the bus is released to other tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drives are being read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>settings are being written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drives have not been read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every setting is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what differs is for a person to change: select its line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drives are switched on, press &quot;Switch drives off&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no connection to the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mount moves, press &quot;Hold&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Forbidden</name>
    <message>
        <source>forbidden: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>az %1  el %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GpredictSettings</name>
    <message>
        <source>address of this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gpredict: rotctld does not listen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gpredict: Host %1, Port %2, Az type %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gpredict: Edit &gt; Preferences &gt; Interfaces &gt; Rotators &gt; Add New
Host: %1
Port: %2
Az type: %3
Min Az: %4  Max Az: %5  Min El: 0  Max El: 90
Antenna Control: Cycle 1000 msec, Threshold 0.1 deg
</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HorizonFiles</name>
    <message>
        <source>the file is too long for a horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 more at an azimuth that has a higher one left out</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotionPermission</name>
    <message>
        <source>at the upper limit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the lower limit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bus is released to other tools, press &quot;Take bus back&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no connection to the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is latched, press &quot;Reset stop&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive fault, press &quot;Re-arm&quot; first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a calibration is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the crash-stop proof moves the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which turn the %1 is on is not known: answer the question (Ctrl+9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which turn the %1 is on is not known yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotPicture</name>
    <message>
        <source>Sky plot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RegionEdit</name>
    <message>
        <source>keep-out %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>azimuth limit
from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>azimuth limit
to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lowest elevation
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highest elevation
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizon
az %1
el %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
az %2
el %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SkyItems</name>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>az %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAGNIFIED ×%1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SkyLimits</name>
    <message>
        <source>below %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of limits</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commanded − actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greatest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>board hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>q current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2%3, in between %4%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SurveyWords</name>
    <message>
        <source>The bus is released to other tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drives have been read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drives have not been read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing moves until it is taken back; then the drives are read anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing may move: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit to move, drives switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit to move, drives switched off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>Night</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmLine</name>
    <message>
        <source>Worst alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was done and what to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge all alarms (F8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give to clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  (%1 unacknowledged)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  over:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the drive fault. The mount then stands in STANDBY; nothing moves by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release STOP. The mount then stands in STANDBY; nothing moves by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let rotctld clients move the mount again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the mount for the operator: motion commands of clients are refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmModel</name>
    <message>
        <source>active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boresight: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To do: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ackn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge the selected alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge all alarms (F8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ackn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound at a new alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sound at each new alarm, once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all are acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no alarm is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is over</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::AskingPanel</name>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What will happen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back, nothing is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::AxisReadout</name>
    <message>
        <source>TURN?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>age %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the turn is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 axis, %2 … %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
mechanical angle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
rate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>supply </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>torque </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
moteus mode %1, fault %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ACTUAL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TARGET</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STATE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actual %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::CableBar</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the azimuth cable is wound: 0° is not wound, the hatched ends are out of travel.
▼ actual, | commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TURN?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ cable</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ChartsPanel</name>
    <message>
        <source>The charts stand in the place of the sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts back to this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the sky again (Ctrl+L)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ClientModel</name>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3 commands a second, last %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ wants to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ClientsPanel</name>
    <message>
        <source>Who may connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the selected client</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings for Gpredict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first client moves the mount until it is silent for 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever sent the last target moves the mount, as with Hamlib</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the host of one client: select it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected client moves the mount from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected client may only read and stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hang up; its program may connect again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only programs on the host of the selected client move the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who moves:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the settings for Gpredict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that Gpredict must be told, for its dialogs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked to
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld does not listen: no program can connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May connect to %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any program on this computer may connect (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever can reach %1 may connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected client may move the mount again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: last command %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You have the control: clients&apos; motions are refused until you give it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a client to give it the control, or to keep it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>apply or revert the edits of the profile first (Ctrl+3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who moves: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::CommandButton</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>requested</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::DrivesPanel</name>
    <message>
        <source>Rate of the proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast each axis moves when its drive is not fed any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>id %1 (%2, %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also on the bus, not in the profile: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not proved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: stopped after %2 in %3 s, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another drive, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown boards on the bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Survey of the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May the mount move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crash-stop proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run (both axes) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UUID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FIRMWARE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REGISTER MAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TURN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the %2 drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crash-stop proof: how each axis stops when its drive is really not fed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crash stop of the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take bus back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the adapter again and read the drives anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the adapter to other tools (tview, moteus_tool). Nothing moves until it is taken back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed the drives again and hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move each axis, stop feeding its drive, measure; asks first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the bus while the drives are switched on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody feeds the drives any more, and each does what its own setting says (&quot;When not fed&quot; on the Protection panel). With the factory setting an unbalanced elevation creeps down.

A drive that is switched on again later gives no torque for a moment (13 ms and the two ticks before): an unbalanced elevation then drops a little.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the mount at %1 and let it run out?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One axis after the other moves at %1. Then Boresight really stops feeding its drive, as if the cable were cut, and measures how far and how long the axis goes on. To be switched on again a drive gives no torque for a moment (13 ms and the two ticks before): an unbalanced elevation drops a little.

Keep people and ropes clear of the antenna. STOP ends the proof.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the mount</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::HeaderBar</name>
    <message>
        <source>CAN off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CAN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CAN down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CAN lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 frames sent, %3 received, %4 dropped, %5 bus errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld does not listen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld listens on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, driving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, last command %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason of the state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target limited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target and who gave it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CAN bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who may move the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who may move the mount. While the operator has the control, motion commands of rotctld clients are refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bus released to other tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LIMITED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The target is outside the limits: the mount goes to the nearest permitted point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control: operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control: clients</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::HelpPage</name>
    <message>
        <source>Pause, F12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP from anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close the menu or dialog, cancel a drag; else STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog while held, after a click on the pad; up and down move elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift + arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the go-to fields; Enter = Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>park</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+1 … Ctrl+5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>panels Jog, Charts, Limits, Clients, Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+6, Ctrl+7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mount itself: Drives, Protection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which turn is the axis on? (while asked)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charts in the place of the sky, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change the limits on the plot: drag (Shift: 0.1°), + adds, Del removes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+0, Ctrl++, Ctrl+-</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnify the plot around the target; also the wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledge the alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>theme: day, night, red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drives: who is on the bus, the bus for other tools, and how each axis stops when not fed.
Protection: ■ dangerous settings keep the mount from moving; Fix writes them, with the
drives switched off. ▲ Turn?: until it is answered only slow jogging is possible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is a function of this program: the mount slows down and holds. It does not
replace the hard-wired emergency stop beside the mast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language of the program&apos;s texts, from its next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in force at the next start</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::HorizonModel</name>
    <message>
        <source>there is a point at this azimuth already</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogButton</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>requested</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogPad</name>
    <message>
        <source>EL +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation up while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EL -</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation down while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ -</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth counter-clockwise while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AZ +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth clockwise while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow down and hold the position (Ctrl+H)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter arms the arrow keys; then they move the mount while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ARMED: arrow keys move the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click here to arm the arrow keys</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogPanel</name>
    <message>
        <source>%1 in degrees, e.g. 113.5 (Ctrl+G; Enter = Go)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this direction by the nearest turn (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to azimuth 0° and the lowest elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Park</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the park position %1 (Ctrl+P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: jog at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step is %1 (Ctrl + arrow)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step mode: a press moves one step only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Az</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>El</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: only slow until the turn is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go: the azimuth is not a number (decimal point, e.g. 113.5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go: the elevation is not a number (decimal point, e.g. 10.5)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LeadPrompt</name>
    <message>
        <source>Port %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 wants to drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A client wants to drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This client moves the mount from now on (panel Clients, Ctrl+4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not asked again while it stays connected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LimitRow</name>
    <message>
        <source>Lowest %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel of the %1, hatched where the limits end; the pointer is where it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, within the travel %2…%3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LimitsPanel</name>
    <message>
        <source>Horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep-outs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the text was not taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: type into a cell, or drag on the plot (Edit, Ctrl+E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a point of the horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the current point of the horizon (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizon from and to a file (az el)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add keep-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a keep-out around where the mount points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the current keep-out (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep-outs, clockwise from … to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select a row first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizon (*.txt *.hrz *.hzn *.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizon (*.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LinesView</name>
    <message>
        <source>Outcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selected line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a line to read it whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected lines, or all that are shown (Ctrl+C in the list)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all lines that are shown to a text file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not written: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogModel</name>
    <message>
        <source>UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogPage</name>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why did it move?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings and alarms only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contains</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogPanel</name>
    <message>
        <source>Alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms of now and since the start of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why did it move?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who moved the mount, and why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every line of the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::MainWindow</name>
    <message>
        <source>Last line of the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this direction by the nearest turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boresight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the hard-wired emergency stop if the mount moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No word from the station for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Old numbers are not shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is not confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was sent, but the status does not show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the mount and close?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping and closing …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::PanelTabs</name>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog panel (Ctrl+1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position, error and drive over the time (Ctrl+2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits, horizon and keep-outs (Ctrl+3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotctld clients, and who of them moves the mount (Ctrl+4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log panel (Ctrl+5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Turn?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which turn is the axis on? (Ctrl+9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mount itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drives, bus and crash-stop proof (Ctrl+6)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drives&apos; own protections (Ctrl+7)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlotEditor</name>
    <message>
        <source>Limits on the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same limits are changed by the keyboard in the Limits panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag an edge, a corner, a point or a whole keep-out (Shift: 0.1°). Double click or +: point of the horizon. Del: remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this point of the horizon (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1 (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a point of the horizon here (+)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a keep-out here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>az %1
el %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlotTools</name>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change limits, horizon and keep-outs on the plot (Ctrl+E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnify around the target (Ctrl+0; Ctrl++, Ctrl+-, wheel)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the plot as a picture (PNG or SVG)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the plot as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::PolarPlot</name>
    <message>
        <source>FLIP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>North is up, east is right, the zenith in the centre. A click reads a direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last seen at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perhaps at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProfileDraft</name>
    <message>
        <source>the station has not answered yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing has been changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the profile was changed from elsewhere meanwhile: keep these edits or revert first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>apply or revert the edits first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no change has been applied here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing waits for a reconnect</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProfileDraftBar</name>
    <message>
        <source>Changes of the profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the changes in force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop the changes that are not applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply again what was in force before the last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put these changes upon what was changed from elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin anew with the drives; the mount must be at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed from elsewhere meanwhile: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waits for a reconnect: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All changes are applied</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::PromptBar</name>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtectionModel</name>
    <message>
        <source>Bus address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watchdog time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When not fed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque not fed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Braking margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. supply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accel. limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max. slip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>advised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dangerous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: wanted %2, found %3.
%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2: %3 → %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2: %3, wanted %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found AZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found EL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtectionPanel</name>
    <message>
        <source>Survey of the drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the selected setting matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look who is on the bus and read all settings anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fix …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the settings that differ; asks first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch drives off …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release both axes; asks first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a line to read why it matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dangerous, %2 advised. Select a line to read why it matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is in force already is kept in the drives&apos; memory. Nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>

Written, read back, and kept in the drives&apos; memory. Nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>

Left for you, because only the builder of the mount can know it:
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write these settings into the drives?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch both drives off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both axes are let go at once. An unbalanced elevation falls, and wind may turn the azimuth. Keep people away from the antenna, or support it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::RegionTableModel</name>
    <message>
        <source>&quot;%1&quot; is not a number (decimal point, e.g. 113.5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Az °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>El °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max °</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::RequestDesk</name>
    <message>
        <source>the station does not answer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::StopButton</name>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP (Esc, Pause or F12): the mount slows down and holds until &quot;Reset stop&quot;.
This is a function of the program. It does not replace the hard-wired emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>requested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latched</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::StripCharts</name>
    <message>
        <source>Remark on the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the picture; the data are collected on (Space in the charts)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the charts in the place of the sky, and back (Ctrl+L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at the curves to read them; or Tab, then the arrow keys. Space: pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the last %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts of the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity of the drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the lowest strip shows of the drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−%1 s  %2Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 before %3Z, paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, last %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::TimeAxis</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::TurnBar</name>
    <message>
        <source>Places the axis may be at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◇ a place the axis may be at, filled: the chosen one; the hatched ends are out of travel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 places, chosen %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 places, none chosen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::TurnPage</name>
    <message>
        <source>Selected place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moved since the question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moved +000.0° since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It stands there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected place for the truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle read off the mount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the axis stands, in degrees of its own travel, e.g. 45.5 or -120</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The axis stands at about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which turn is the %1 on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So %1 is proposed. Look at the mount before you confirm it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This does not tell the place. Look at the mount.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The axis stands at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moved %1 since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selects %1, place %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stands at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select where the axis stands first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read the question first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>boresight::ui::UnwindButtons</name>
    <message>
        <source>Unwind ↺
(hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn counter-clockwise at %1 while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unwind ↻
(hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn clockwise at %1 while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower ↓
(hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower at %1 while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise ↑
(hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise at %1 while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unwind: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
