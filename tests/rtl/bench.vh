// What every bench of a stage holds. It has a STAGE, ROWS and BITS of its own. Each clock brings a
// row; a value of latency n is that of the row n clocks before.
    reg [BITS-1:0] rows [0:ROWS-1];
    reg            clock;
    integer        edges, wrong, i;

    initial begin
        $readmemh({"tests/vectors/", STAGE, ".hex"}, rows);
        clock = 0;
        edges = 0;
        wrong = 0;
        done = 0;
    end
    always #1 clock = !clock;

    wire [BITS-1:0] row = rows[edges < ROWS ? edges : ROWS - 1];

    // Column and number are its name: number -1 for a column without one. Ten differences are told.
    task expect_equal(input [8*10-1:0] column, input integer number, input integer at,
        input [63:0] expected, input [63:0] found);
        if (found !== expected) begin
            wrong = wrong + 1;
            if (wrong <= 10) begin
                $write("# %0s-%05d %0s", STAGE, at, column);
                if (number >= 0) $write("%0d", number);
                $display(": expected %h, found %h", expected, found);
            end
        end
    endtask

    task finish_after(input integer latency);
        if (edges == ROWS - 1 + latency) begin
            if (wrong == 0) $display("PASS %0s %0d", STAGE, ROWS);
            else $display("FAIL %0s %0d", STAGE, wrong);
            done = 1;
        end
    endtask

`undef EXPECT
`define EXPECT(latency, column, number, select, found) \
    if (edges >= latency && edges - latency < ROWS) \
        expect_equal(column, number, edges - latency, rows[edges-latency][select], found)
